#include "fuzz/pipe/query_stream.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <atomic>
#include <exception>
#include <optional>

#include "fuzz/queries/address.h"
#include "fuzz/files/query_file.h"

namespace axiscert {
namespace {

constexpr std::uint64_t block_size = 4096;

struct Block {
  const Source* source;
  std::uint64_t first, size;
};

// The blocks of a plan in order.
class Blocks {
 public:
  explicit Blocks(const PipePlan& plan) : plan_(plan) {}
  std::optional<Block> next() {
    while (part_ < plan_.parts.size() && done_ == plan_.parts[part_].queries) {
      ++part_;
      done_ = 0;
    }
    if (part_ == plan_.parts.size()) return std::nullopt;
    const Block block{plan_.parts[part_].source.get(), done_, std::min(block_size, plan_.parts[part_].queries - done_)};
    done_ += block.size;
    return block;
  }

 private:
  const PipePlan& plan_;
  std::size_t part_ = 0;
  std::uint64_t done_ = 0;
};

template <class Real>
std::string encoded(const Block& block, std::uint64_t seed, QueryEncoding encoding) {
  const Source& source = *block.source;
  const std::size_t columns = source.columns().size();
  QueryBatch<Real> batch(block.size, columns);
  source.fill(seed, block.first, block.size, batch);
  std::string bytes;
  if (encoding == QueryEncoding::binary) bytes.reserve(block.size * columns * sizeof(Real));
  for (std::size_t i = 0; i < block.size; ++i) {
    const Numbers<Real> numbers = batch[i];
    switch (encoding) {
      case QueryEncoding::binary:
        bytes.append(reinterpret_cast<const char*>(numbers.data()), columns * sizeof(Real));
        break;
      case QueryEncoding::json_lines: {
        const Address address = address_of(source, seed, precision_of<Real>, block.first + i);
        bytes += query_line({text(address), precision_of<Real>, numbers, &source.predicate(), source.entry()}) + '\n';
        break;
      }
    }
  }
  return bytes;
}

}  // namespace

void write_queries(const PipePlan& plan, QueryEncoding encoding, int threads,
                   const std::function<void(std::string_view)>& write) {
  if (encoding == QueryEncoding::binary) write(header_of(plan));
  Blocks blocks(plan);
  // Not thrown through the pipeline, which would not free the blocks that are in progress.
  std::exception_ptr failed;
  std::atomic<bool> stopped = false;
  const auto next = [&](tbb::flow_control& flow) {
    const auto block = stopped ? std::nullopt : blocks.next();
    if (!block) flow.stop();
    return block.value_or(Block{});
  };
  const auto encode = [&](const Block& block) {
    return plan.precision == Precision::binary32 ? encoded<float>(block, plan.seed, encoding)
                                                 : encoded<double>(block, plan.seed, encoding);
  };
  const auto put = [&](const std::string& bytes) {
    if (stopped) return;
    try {
      write(bytes);
    } catch (...) {
      failed = std::current_exception();
      stopped = true;
    }
  };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::parallel_pipeline(static_cast<std::size_t>(4 * threads),
                         tbb::make_filter<void, Block>(tbb::filter_mode::serial_in_order, next) &
                             tbb::make_filter<Block, std::string>(tbb::filter_mode::parallel, encode) &
                             tbb::make_filter<std::string, void>(tbb::filter_mode::serial_in_order, put));
  if (failed) std::rethrow_exception(failed);
}

}  // namespace axiscert
