// The side of vulkan_host and opencl_host that shader.mjs talks to.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace host {

[[noreturn]] inline void fail(int code, const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(code);
}

// Says on which device it answers, once it can.
inline void say_device(const std::string& name) { std::fprintf(stderr, "device: %s\n", name.c_str()); }

// Calls answer(numbers, words) for each batch of standard input, a line with the number of queries and then their
// numbers, and writes the words, one for each query.
template <class Answer>
void serve(std::size_t columns, Answer&& answer) {
  std::vector<float> numbers;
  std::vector<std::uint32_t> words;
  for (std::size_t count; std::scanf("%zu", &count) == 1;) {
    std::getchar();
    numbers.resize(count * columns);
    words.assign(count, 0);
    if (std::fread(numbers.data(), sizeof(float), numbers.size(), stdin) != numbers.size())
      fail(2, "a batch ends early");
    answer(numbers, words);
    std::fwrite(words.data(), sizeof(std::uint32_t), words.size(), stdout);
    std::fflush(stdout);
  }
}

}  // namespace host
