// The formulae of kernel/ on an NVIDIA GPU, as a program of the pipe (docs/pipe.md): one thread a query, one launch a
// stream. nvcc's flags say what the compiler may do to them: it contracts by default, and not with -fmad=false.
//
//   cuda_program [--host] KERNEL < queries > replies
//
// --host asks the processor instead, the same functions as the host's compiler has them: what a GPU's replies are compared with.
// Replies have comparison bits where the formulae have comparisons. A fault of the device is a line on standard error
// and exit code 3.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/moving_sphere/segment.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/plugin/pipe_format.h"
#include "kernel/sphere_triangle/forms/filter_kernels.h"
#include "kernel/sphere_triangle/forms/methods.h"
#include "kernel/sphere_triangle/forms/reduced.h"

namespace axiscert::gpu {
namespace {

template <class Real>
__host__ __device__ portable::Problem<Real> still_problem(const Real* q) {
  return {{q[0], q[1], q[2]}, {q[3], q[4], q[5]}, {q[6], q[7], q[8]}, {q[9], q[10], q[11]}, q[12], Real(0)};
}

// What a thread answers: comparison bits, or the verdict where there are none to show.
template <class F, Strictness strictness = Strictness::strict>
struct StillQuestion {
  static constexpr std::size_t columns = 13;
  static constexpr bool has_comparisons = !requires(const portable::Problem<float>& q) { F::separated(q); };

  template <class Real>
  __host__ __device__ static ComparisonBits answer(const Real* q) {
    const portable::Problem<Real> problem = still_problem(q);
    if constexpr (has_comparisons) {
      constexpr ComparisonBits nonstrict = nonstrict_comparisons(strictness);
      ComparisonBits bits = 0;
      F::comparisons(problem, [&](Comparison which, const Real& lhs, const Real& rhs) {
        const bool holds = has_bit(nonstrict, which) ? lhs >= rhs : lhs > rhs;
        if (holds) bits |= one_bit<ComparisonBits>(which);
      });
      return bits;
    } else {
      return F::separated(problem) ? 1 : 0;
    }
  }
  static Verdict verdict(ComparisonBits bits) { return verdict_of(axes_of(bits)); }
};

// The filter that is proved never to answer wrongly (docs/proofs.md).
template <class Filter>
struct FilterQuestion {
  static constexpr std::size_t columns = 13;
  static constexpr bool has_comparisons = false;

  template <class Real>
  __host__ __device__ static ComparisonBits answer(const Real* q) {
    const auto certain = portable::filter_answer<Filter, Real>(still_problem(q));
    return static_cast<ComparisonBits>(certain.separated ? Verdict::separated
                                       : certain.contact ? Verdict::contact
                                                         : Verdict::undecided);
  }
};

// Formulae of a predicate's own type (kernel/formulae_kernel.h). `column_count` is that of its entry.
template <class Test, class F, std::size_t column_count>
struct Question {
  static constexpr std::size_t columns = column_count;
  static constexpr bool has_comparisons =
      !requires(const typename Test::template Problem<float>& q) { F::template separated<float>(q); };

  template <class Real>
  __host__ __device__ static ComparisonBits answer(const Real* q) {
    const auto problem = Test::template problem<Real>([&](std::size_t k) { return q[k]; });
    if constexpr (has_comparisons) return bits_of<F, Real>(problem, [](std::size_t, const Real&, const Real&) {});
    else return F::template separated<Real>(problem) ? 1 : 0;
  }
  static Verdict verdict(ComparisonBits bits) {
    if constexpr (std::is_same_v<Test, MovingSphere>) {
      for (const ComparisonBits clause : moving_sphere::clause_bits) {
        if ((bits & clause) == clause) return Verdict::separated;
      }
      return Verdict::contact;
    } else {
      return bits != 0 ? Verdict::separated : Verdict::contact;  // an axis of boxes is one comparison
    }
  }
};

template <class Q, class Real>
__global__ void answer_all(const Real* numbers, std::size_t count, ComparisonBits* out) {
  const std::size_t i = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (i < count) out[i] = Q::template answer<Real>(numbers + i * Q::columns);
}

[[noreturn]] void fail(const std::string& why, int code = 2) {
  std::fprintf(stderr, "cuda_program: %s\n", why.c_str());
  std::exit(code);
}
void check(cudaError_t error, const char* at) {
  if (error != cudaSuccess) fail(std::string(at) + ": " + cudaGetErrorString(error), 3);
}

// An array on the device.
template <class T>
class DeviceArray {
 public:
  explicit DeviceArray(std::size_t size) { check(cudaMalloc(&data_, size * sizeof(T)), "allocation on the device"); }
  ~DeviceArray() { cudaFree(data_); }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  T* data() const { return data_; }

 private:
  T* data_ = nullptr;
};

template <class Q, class Real>
void launch(const Real* numbers, std::size_t count, ComparisonBits* out) {
  constexpr unsigned threads = 128;
  answer_all<Q, Real><<<static_cast<unsigned>((count + threads - 1) / threads), threads>>>(numbers, count, out);
}

// AXISCERT_GPU_TIMES=n measures the launch alone: the least time of n, in ns a query, on standard error.
template <class Q, class Real>
void measure(const Real* numbers, std::size_t count, ComparisonBits* out, int times) {
  cudaEvent_t start, stop;
  check(cudaEventCreate(&start), "event");
  check(cudaEventCreate(&stop), "event");
  float least = 0;
  for (int i = 0; i < times; ++i) {
    check(cudaEventRecord(start), "event");
    launch<Q, Real>(numbers, count, out);
    check(cudaEventRecord(stop), "event");
    check(cudaEventSynchronize(stop), "launch");
    float milliseconds = 0;
    check(cudaEventElapsedTime(&milliseconds, start, stop), "event");
    if (i == 0 || milliseconds < least) least = milliseconds;
  }
  std::fprintf(stderr, "%.4f ns a query, least of %d launches of %zu queries\n", least * 1e6 / double(count), times,
               count);
}

template <class Q, class Real>
void answer_on_device(const std::vector<char>& records, std::size_t count, std::vector<ComparisonBits>& bits) {
  const DeviceArray<Real> numbers(count * Q::columns);
  const DeviceArray<ComparisonBits> out(count);
  check(cudaMemcpy(numbers.data(), records.data(), records.size(), cudaMemcpyHostToDevice), "copy to the device");
  launch<Q, Real>(numbers.data(), count, out.data());
  check(cudaGetLastError(), "launch");
  check(cudaMemcpy(bits.data(), out.data(), count * sizeof(ComparisonBits), cudaMemcpyDeviceToHost),
        "copy from the device");
  if (const char* times = std::getenv("AXISCERT_GPU_TIMES")) {
    measure<Q, Real>(numbers.data(), count, out.data(), std::atoi(times));
  }
}

bool is_on_host = false;

template <class Q, class Real>
void answer_stream(const std::vector<char>& records, std::size_t count) {
  if (count == 0) return;
  std::vector<ComparisonBits> bits(count);
  if (is_on_host) {
    const auto* numbers = reinterpret_cast<const Real*>(records.data());
    for (std::size_t i = 0; i < count; ++i) bits[i] = Q::template answer<Real>(numbers + i * Q::columns);
  } else {
    answer_on_device<Q, Real>(records, count, bits);
  }
  std::vector<pipe::ReplyRecord> replies(count);
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (Q::has_comparisons) {
      replies[i] = {static_cast<std::uint8_t>(Q::verdict(bits[i])), pipe::has_bits, {}, bits[i]};
    } else {
      replies[i].verdict = static_cast<std::uint8_t>(bits[i]);
    }
  }
  std::fwrite(replies.data(), sizeof(pipe::ReplyRecord), count, stdout);
}

struct Kernel {
  const char* id;
  std::size_t columns;
  void (*binary32)(const std::vector<char>&, std::size_t);
  void (*binary64)(const std::vector<char>&, std::size_t);
};
template <class Q>
constexpr Kernel kernel(const char* id) {
  return {id, Q::columns, answer_stream<Q, float>, answer_stream<Q, double>};
}

constexpr Kernel kernels[] = {
    kernel<StillQuestion<portable::PublishedFormulae>>("published"),
    kernel<StillQuestion<portable::ReducedFormulae, Strictness::nonstrict>>("reduced-nonstrict"),
    kernel<StillQuestion<portable::ReducedAlong, Strictness::nonstrict>>("reduced-along-nonstrict"),
    kernel<StillQuestion<methods::ClosestPoint>>("closest-point"),
    kernel<FilterQuestion<portable::ReducedFilter>>("certified-filter"),
    kernel<Question<MovingSphere, moving_sphere::TwentyNonstrict, 16>>("moving-sphere/twenty-nonstrict"),
    kernel<Question<MovingSphere, moving_sphere::Segment, 16>>("moving-sphere/segment"),
    kernel<Question<boxes::MatrixBoxes, boxes::ProjectedFifteen, 30>>("box-box/projected"),
    kernel<Question<boxes::MatrixBoxes, boxes::Textbook, 30>>("box-box/textbook"),
};

bool read_all(void* to, std::size_t size) { return std::fread(to, 1, size, stdin) == size; }

void serve(const Kernel& asked) {
  pipe::Head head;
  for (std::size_t got; (got = std::fread(&head, 1, sizeof head, stdin)) != 0;) {
    if (got != sizeof head || head.magic != pipe::magic || head.version != pipe::version ||
        head.header_size < sizeof head || head.header_size > pipe::greatest_header) {
      fail("standard input is not a query stream of version 3; `axiscert generate --binary` makes one");
    }
    const bool is_wide = head.precision == 64;
    if (head.record_size != asked.columns * (is_wide ? 8 : 4)) {
      fail("a query of " + std::string(asked.id) + " has " + std::to_string(asked.columns) + " numbers; a record has " +
           std::to_string(head.record_size) + " bytes");
    }
    std::vector<char> plan(head.header_size - sizeof head), records(head.count * head.record_size);
    if (!read_all(plan.data(), plan.size()) || !read_all(records.data(), records.size())) fail("the stream ends early");
    std::fwrite(&head, sizeof head, 1, stdout);
    std::fwrite(plan.data(), 1, plan.size(), stdout);
    (is_wide ? asked.binary64 : asked.binary32)(records, head.count);
    std::fflush(stdout);
  }
}

int main_of(int argc, char** argv) {
  std::string ids;
  is_on_host = argc == 3 && std::strcmp(argv[1], "--host") == 0;
  for (const Kernel& one : kernels) {
    if (argc == (is_on_host ? 3 : 2) && std::strcmp(argv[argc - 1], one.id) == 0) {
      serve(one);
      return 0;
    }
    ids += std::string(" ") + one.id;
  }
  fail("cuda_program [--host] KERNEL, one of:" + ids);
}

}  // namespace
}  // namespace axiscert::gpu

int main(int argc, char** argv) { return axiscert::gpu::main_of(argc, argv); }
