// The device that shaders run on: the machine's own GPU, or SwiftShader of a Chromium where there is none.
//
// AXISCERT_GPU=hardware asks for the first alone, =software for the second alone.
import os from 'node:os';
import {existsSync} from 'node:fs';

// Chromium's folder in Debian: it has a Vulkan loader too.
const CHROMIUM = process.env.AXISCERT_CHROMIUM ?? '/usr/lib/chromium';
const SOFTWARE = `${CHROMIUM}/vk_swiftshader_icd.json`;
const RTLD_NODELETE = 0x1000;  // Linux: node closes what is no module of its own, and this keeps it

// Dawn asks for libvulkan.so.1 by name, and finds the one that is loaded already.
function loadChromiumsLoader() {
  const file = `${CHROMIUM}/libvulkan.so.1`;
  if (!existsSync(file)) return;
  try {
    process.dlopen({exports: {}}, file, RTLD_NODELETE | os.constants.dlopen.RTLD_NOW | os.constants.dlopen.RTLD_GLOBAL);
  } catch {
    // It is no module of node; it stays loaded.
  }
}

async function webgpu() {
  try {
    return await import('webgpu');
  } catch (error) {
    throw new Error(`NOT CHECKED: the package webgpu cannot be loaded (${error.message.split('\n')[0]}); ./dev gpu brings it`);
  }
}

async function adapterOf(create) {
  // The object of create() has to outlive every adapter: without a reference to it the process crashes at random.
  globalThis.axiscertGpu = create([]);
  return globalThis.axiscertGpu.requestAdapter();
}

// An adapter, or an Error that says what was looked for.
export async function openAdapter() {
  const wish = process.env.AXISCERT_GPU ?? '';
  const {create, globals} = await webgpu();
  Object.assign(globalThis, globals);
  let adapter = null;
  if (wish === 'software') process.env.VK_ICD_FILENAMES = SOFTWARE;
  if (wish === 'software') loadChromiumsLoader();
  adapter = await adapterOf(create);
  if (adapter === null && wish === '' && existsSync(SOFTWARE)) {
    process.env.VK_ICD_FILENAMES = SOFTWARE;
    loadChromiumsLoader();
    adapter = await adapterOf(create);
  }
  if (adapter === null) {
    throw new Error(wish === 'hardware' ? 'NOT CHECKED: no GPU adapter: Vulkan offers none' :
      `NOT CHECKED: no GPU adapter: Vulkan offers none, and ${SOFTWARE} is ${existsSync(SOFTWARE) ? 'not usable' : 'not there'}; ./dev gpu brings it`);
  }
  return adapter;
}

export const nameOf = ({info}) => [info.vendor, info.architecture, info.device, info.description].filter(Boolean).join(', ');
