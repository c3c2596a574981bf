// Runs a kernel of OpenCL C for shader.mjs: batches of numbers in, a word for each query out.
//
//   opencl_host FILE.cl COLUMNS [DEVICE [OPTIONS]]
//
// FILE has the kernel axiscert_main(numbers, words out, number of queries). DEVICE is a word that the device's name has
// to have; OPTIONS go to its compiler, as -cl-fast-relaxed-math. A batch is a line of standard input with the number of
// queries, then the numbers; standard error has a line with the device's name. What the compiler says is a text there,
// exit code 2; a fault of the device is a line, exit code 3.
#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "host_pipe.h"

namespace {

constexpr std::size_t least = 1024;  // invocations of a dispatch

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

cl::Device chosen(const std::string& wanted) {
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    // There is none.
  }
  std::string names;
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> devices;
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    for (const cl::Device& device : devices) {
      const std::string name = device.getInfo<CL_DEVICE_NAME>() + ", " + platform.getInfo<CL_PLATFORM_NAME>();
      if (lower(name).find(lower(wanted)) != name.npos) return device;
      names += names.empty() ? name : ", " + name;
    }
  }
  host::fail(2, "NOT CHECKED: no OpenCL device" + (wanted.empty() ? "" : " whose name has '" + wanted + "'") +
                    (names.empty() ? "" : "; there is " + names));
}

void serve(const char* file, std::size_t columns, const std::string& wanted, const std::string& options) {
  const cl::Device device = chosen(wanted);
  const cl::Context context(device);
  std::ifstream stream(file);
  const cl::Program program(context, std::string{std::istreambuf_iterator<char>(stream), {}});
  try {
    program.build({device}, options.c_str());
  } catch (const cl::Error&) {
    host::fail(2, program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device));
  }
  cl::Kernel kernel(program, "axiscert_main");
  const cl::CommandQueue queue(context, device);
  const auto dispatch = [&](const cl::Buffer& in, const cl::Buffer& out, std::size_t count) {
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    kernel.setArg(2, static_cast<cl_uint>(count));
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(std::max(count + least - 1, least) / least * least),
                               cl::NDRange(64));
  };
  // Some compile at the first dispatch alone: that is no part of an answer's time.
  const cl::Buffer word(context, CL_MEM_READ_WRITE, 4);
  dispatch(word, word, 0);
  queue.finish();
  host::say_device(device.getInfo<CL_DEVICE_NAME>() + ", " +
                   cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>());
  cl::Buffer in, out;
  std::size_t room = 0;  // queries
  host::serve(columns, [&](std::vector<float>& numbers, std::vector<std::uint32_t>& words) {
    if (words.empty()) return;
    if (words.size() > room) {
      room = words.size();
      in = cl::Buffer(context, CL_MEM_READ_ONLY, 4 * numbers.size());
      out = cl::Buffer(context, CL_MEM_WRITE_ONLY, 4 * room);
    }
    queue.enqueueWriteBuffer(in, true, 0, 4 * numbers.size(), numbers.data());
    dispatch(in, out, words.size());
    queue.enqueueReadBuffer(out, true, 0, 4 * words.size(), words.data());
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) host::fail(2, "opencl_host FILE.cl COLUMNS [DEVICE [OPTIONS]]");
  try {
    serve(argv[1], std::stoul(argv[2]), argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "");
  } catch (const cl::Error& error) {
    host::fail(3, std::string(error.what()) + ": error " + std::to_string(error.err()) + " of OpenCL");
  } catch (const std::exception& error) {
    host::fail(3, error.what());
  }
}
