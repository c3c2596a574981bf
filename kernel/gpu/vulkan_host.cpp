// Runs a shader of GLSL on Vulkan for shader.mjs: batches of numbers in, a word for each query out.
//
//   vulkan_host FILE.spv COLUMNS [DEVICE]
//
// Bindings of set 0, storage buffers of 32-bit words: 0 numbers, 1 words out, 2 zero and the number of queries. A group
// has 64 invocations. DEVICE is a word that the device's name has to have. A batch is a line of standard input with the
// number of queries, then the numbers; standard error has a line with the device's name. A fault of the device is a
// line there, exit code 3.
#include <vulkan/vulkan.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "host_pipe.h"

namespace {

constexpr std::uint32_t group = 64;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The first device whose name has the word: a GPU before what runs on the processor.
vk::PhysicalDevice chosen(const vk::Instance& instance, const std::string& wanted) {
  std::vector<vk::PhysicalDevice> all = instance.enumeratePhysicalDevices();
  std::ranges::stable_sort(all, {}, [](const vk::PhysicalDevice& device) {
    return device.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
  });
  std::string names;
  for (const vk::PhysicalDevice& device : all) {
    const std::string name = device.getProperties().deviceName;
    if (lower(name).find(lower(wanted)) != name.npos) return device;
    names += names.empty() ? name : ", " + name;
  }
  host::fail(2, "NOT CHECKED: no Vulkan device" + (wanted.empty() ? "" : " whose name has '" + wanted + "'") +
                    (names.empty() ? "" : "; there is " + names));
}

// A storage buffer in memory that both sides see.
struct Buffer {
  vk::UniqueBuffer buffer;
  vk::UniqueDeviceMemory memory;
  void* mapped = nullptr;
};

Buffer made(const vk::PhysicalDevice& physical, const vk::Device& device, vk::DeviceSize size) {
  Buffer made;
  made.buffer = device.createBufferUnique({{}, size, vk::BufferUsageFlagBits::eStorageBuffer});
  const vk::MemoryRequirements needs = device.getBufferMemoryRequirements(*made.buffer);
  const vk::PhysicalDeviceMemoryProperties kinds = physical.getMemoryProperties();
  constexpr auto seen = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  for (std::uint32_t i = 0; i < kinds.memoryTypeCount; ++i) {
    if ((needs.memoryTypeBits >> i & 1) == 0 || (kinds.memoryTypes[i].propertyFlags & seen) != seen) continue;
    made.memory = device.allocateMemoryUnique({needs.size, i});
    device.bindBufferMemory(*made.buffer, *made.memory, 0);
    made.mapped = device.mapMemory(*made.memory, 0, VK_WHOLE_SIZE);
    return made;
  }
  host::fail(3, "the device has no memory that the host sees");
}

void serve(const char* file, std::size_t columns, const std::string& wanted) {
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::uint32_t> code(bytes.size() / 4);
  std::copy_n(bytes.begin(), 4 * code.size(), reinterpret_cast<char*>(code.data()));

  const vk::ApplicationInfo application("axiscert", 1, nullptr, 0, VK_API_VERSION_1_1);
  const vk::UniqueInstance instance = vk::createInstanceUnique({{}, &application});
  const vk::PhysicalDevice physical = chosen(*instance, wanted);
  const std::string name = physical.getProperties().deviceName;
  host::say_device(name);
  const std::vector<vk::QueueFamilyProperties> families = physical.getQueueFamilyProperties();
  const auto family = static_cast<std::uint32_t>(
      std::ranges::find_if(families, [](const auto& f) { return bool(f.queueFlags & vk::QueueFlagBits::eCompute); }) -
      families.begin());
  constexpr float priority = 1;
  const vk::DeviceQueueCreateInfo queues({}, family, 1, &priority);
  const vk::UniqueDevice device = physical.createDeviceUnique({{}, queues});
  const vk::Queue queue = device->getQueue(family, 0);

  std::array<vk::DescriptorSetLayoutBinding, 3> bindings;
  for (std::uint32_t i = 0; i < bindings.size(); ++i)
    bindings[i] = {i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute};
  const vk::UniqueDescriptorSetLayout set_layout = device->createDescriptorSetLayoutUnique({{}, bindings});
  const vk::UniquePipelineLayout layout = device->createPipelineLayoutUnique({{}, *set_layout});
  const vk::UniqueShaderModule module = device->createShaderModuleUnique({{}, code});
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
  const vk::UniquePipeline pipeline = device->createComputePipelineUnique({}, {{}, stage, *layout}).value;
  const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 3);
  const vk::UniqueDescriptorPool pool = device->createDescriptorPoolUnique({{}, 1, size});
  const vk::DescriptorSet set = device->allocateDescriptorSets({*pool, *set_layout}).front();
  const vk::UniqueCommandPool commands = device->createCommandPoolUnique({{}, family});
  const vk::UniqueFence fence = device->createFenceUnique({});

  std::array<Buffer, 3> buffers;
  std::size_t room = 0;  // queries
  host::serve(columns, [&](const std::vector<float>& numbers, std::vector<std::uint32_t>& words) {
    if (words.size() > room) {
      room = words.size();
      buffers = {made(physical, *device, 4 * numbers.size()), made(physical, *device, 4 * room),
                 made(physical, *device, 8)};
      for (std::uint32_t i = 0; i < buffers.size(); ++i) {
        const vk::DescriptorBufferInfo info(*buffers[i].buffer, 0, VK_WHOLE_SIZE);
        device->updateDescriptorSets(vk::WriteDescriptorSet(set, i, 0, vk::DescriptorType::eStorageBuffer, {}, info),
                                     {});
      }
    }
    std::ranges::copy(numbers, static_cast<float*>(buffers[0].mapped));
    const std::array<std::uint32_t, 2> zero{0, static_cast<std::uint32_t>(words.size())};
    std::ranges::copy(zero, static_cast<std::uint32_t*>(buffers[2].mapped));
    const auto buffer =
        std::move(device->allocateCommandBuffersUnique({*commands, vk::CommandBufferLevel::ePrimary, 1}).front());
    buffer->begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    buffer->bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
    buffer->bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, set, {});
    buffer->dispatch((zero[1] + group - 1) / group, 1, 1);
    buffer->pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                            vk::MemoryBarrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead), {}, {});
    buffer->end();
    queue.submit(vk::SubmitInfo({}, {}, *buffer), *fence);
    if (device->waitForFences(*fence, true, UINT64_MAX) != vk::Result::eSuccess)
      host::fail(3, "the device gave no answer");
    device->resetFences(*fence);
    std::copy_n(static_cast<const std::uint32_t*>(buffers[1].mapped), words.size(), words.begin());
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) host::fail(2, "vulkan_host FILE.spv COLUMNS [DEVICE]");
  try {
    serve(argv[1], std::stoul(argv[2]), argc == 4 ? argv[3] : "");
  } catch (const std::exception& error) {
    host::fail(3, error.what());
  }
}
