#include "kernel/plugin/host/fault_handler.h"

#include <sys/mman.h>
#include <ucontext.h>

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace axiscert::plugin {
namespace {

constexpr std::uintptr_t null_page = 4096;  // a member of what a null pointer points to

const Arrays* watched = nullptr;
Fault* told = nullptr;

// The processor's description of a page fault.
Access access_of(const void* context) {
#if defined(__x86_64__)
  constexpr greg_t page_fault = 14, write_bit = 2;
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  if (registers[REG_TRAPNO] != page_fault) return Access::unknown;
  return (registers[REG_ERR] & write_bit) ? Access::write : Access::read;
#else
  static_cast<void>(context);
  return Access::unknown;
#endif
}

// A stack that is full faults just below its pointer.
bool is_out_of_stack(const void* context, const std::byte* address) {
#if defined(__x86_64__)
  const auto pointer = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RSP];
  const auto distance = static_cast<greg_t>(reinterpret_cast<std::uintptr_t>(address)) - pointer;
  constexpr greg_t near = 1 << 16;
  return -near < distance && distance < near;
#else
  static_cast<void>(context), static_cast<void>(address);
  return false;
#endif
}

// In which array's area, or in whose half of a guard, the address lies.
void locate(const std::byte* address, Fault& fault) {
  const Arrays& arrays = *watched;
  const std::ptrdiff_t from_first = address - arrays.area(0), half_guard = static_cast<std::ptrdiff_t>(guard / 2);
  const auto slot = static_cast<std::ptrdiff_t>(arrays.slot());
  if (from_first < -half_guard ||
      from_first + half_guard >= static_cast<std::ptrdiff_t>(arrays.shape.arrays()) * slot) {
    return;
  }
  fault.in_arrays = true;
  fault.array = static_cast<std::uint32_t>((from_first + half_guard) / slot);
  const auto element = static_cast<std::ptrdiff_t>(entry_bytes(arrays.shape, fault.array, arrays.placed.real));
  const std::ptrdiff_t bytes = address - arrays.first(fault.array);
  fault.element = bytes >= 0 ? bytes / element : -((-bytes + element - 1) / element);
  fault.element_count = arrays.placed.size;
}

void handle(int signal, siginfo_t* info, void* context) {
  Fault& fault = *told;
  fault.signal = signal;
  if (signal == SIGSEGV || signal == SIGBUS) {
    const auto* const address = static_cast<const std::byte*>(info->si_addr);
    fault.at_null = reinterpret_cast<std::uintptr_t>(address) < null_page;
    fault.access = access_of(context);
    if (!fault.at_null) {
      locate(address, fault);
      fault.out_of_stack = !fault.in_arrays && is_out_of_stack(context, address);
    }
  }
  // SA_RESETHAND: what did it happens again and kills the process. One that was sent does not happen again.
  if (info->si_code <= 0) raise(signal);
}

}  // namespace

void watch_for_faults(const Arrays& arrays, Fault& fault) {
  watched = &arrays;
  told = &fault;
  static std::byte stack[1 << 16];  // a handler needs one where the other is full
  stack_t alternate{};
  alternate.ss_sp = stack;
  alternate.ss_size = sizeof stack;
  sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_sigaction = handle;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int fatal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP}) sigaction(fatal, &action, nullptr);
}

}  // namespace axiscert::plugin
