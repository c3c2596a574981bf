// One sphere against a chunk of triangles of an indexed mesh. Triangles beyond one face of the sphere's box are
// recognised by their vertices and never gathered; the others are made into blocks. No include guard: included once for
// each of Highway's instruction sets, after block-inl.h and outcodes-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// D and D2 are as in Steps. D4 takes one vertex per vector; it is void where there are no four lanes.
template <class D, class D2, class D4>
class MeshSteps {
 public:
  using Real = hn::TFromD<D>;

  MeshSteps(const MeshChunk<Real>& mesh, Question question, Outcodes& outcodes, MeshAnswer& answer) noexcept
      : mesh_(mesh), question_(question), outcodes_(outcodes), answer_(answer) {}

  AXISCERT_INLINE void run() noexcept {
    // The conservative question is asked of every triangle, so that its answers do not depend on the shape of the call.
    std::uint64_t rest[mesh_chunk_size / 64] = {};
    if (mesh_.size >= fewest && question_ != Question::conservative && skip(rest)) ask_the(rest);
    else ask_all();
  }

 private:
  static constexpr std::size_t fewest = 64;
  static constexpr std::size_t words(std::size_t size) { return (size + 63) / 64; }

  const std::uint32_t* vertices_of(std::size_t i) const noexcept {
    return mesh_.indices + 3 * std::size_t{mesh_.list ? mesh_.list[i] : i};
  }
  const Real* vertex(std::uint32_t v) const noexcept { return mesh_.vertices + mesh_.stride * v; }

  // Sets the bits of the triangles that the box does not separate. Returns false and sets none where the box separates
  // few, or where the vertices are not in the table and there are no four lanes.
  HWY_NOINLINE bool skip(std::uint64_t* rest) noexcept {
    const SphereBox<Real> box(mesh_.sphere[0], mesh_.sphere[1], mesh_.sphere[2], mesh_.sphere[3]);
    if (!outcodes_.are_useful && !separates_most(box)) return false;
    const VertexRange range = vertices();
    OutcodeStep<D> outcodes(mesh_, box, outcodes_);
    if (range.end != 0 && outcodes.has(range)) {
      if (outcodes.common(range) == 0) skip_by_outcodes(rest);
    } else if constexpr (!std::is_void_v<D4>) {
      skip_by_vertices(box, range.end - 1, rest);
    } else {
      return false;
    }
    return true;
  }

  // Whether the box separates most of the triangles tried, one in 64.
  AXISCERT_INLINE bool separates_most(const SphereBox<Real>& box) const noexcept {
    std::size_t separated = 0;
    for (std::size_t i = 32; i < mesh_.size; i += 64) {
      const std::uint32_t* v = vertices_of(i);
      separated += (box.beyond(vertex(v[0])) & box.beyond(vertex(v[1])) & box.beyond(vertex(v[2]))) != 0;
    }
    return 2 * separated >= mesh_.size / 64;
  }

  // The range from the least vertex of a triangle to the greatest; its end is 0 where it does not fit in 32 bits.
  HWY_NOINLINE VertexRange vertices() const noexcept {
    std::uint32_t least = ~std::uint32_t{0}, greatest = 0;
    const auto add = [&](std::uint32_t v) {
      least = v < least ? v : least;
      greatest = v > greatest ? v : greatest;
    };
    std::size_t i = 0;
    if (!mesh_.list) {
      const hn::ScalableTag<std::uint32_t> d;
      const std::size_t size = 3 * mesh_.size / hn::Lanes(d) * hn::Lanes(d);
      auto low = hn::Set(d, least), high = hn::Zero(d);
      for (std::size_t k = 0; k < size; k += hn::Lanes(d)) {
        const auto v = hn::LoadU(d, mesh_.indices + k);
        low = hn::Min(low, v);
        high = hn::Max(high, v);
      }
      least = hn::GetLane(hn::MinOfLanes(d, low));
      greatest = hn::GetLane(hn::MaxOfLanes(d, high));
      i = size / 3;
    }
    for (; i < mesh_.size; ++i) {
      const std::uint32_t* v = vertices_of(i);
      add(v[0]);
      add(v[1]);
      add(v[2]);
    }
    return {least, greatest + 1};
  }

  HWY_NOINLINE void skip_by_outcodes(std::uint64_t* rest) const noexcept {
    alignas(64) std::uint8_t common[mesh_chunk_size];
    const auto code = [from = reinterpret_cast<std::uintptr_t>(outcodes_.code) - outcodes_.first](std::uint32_t v) {
      return unsigned{*reinterpret_cast<const std::uint8_t*>(from + v)};
    };
    for (std::size_t i = 0; i < mesh_.size; ++i) {
      const std::uint32_t* v = vertices_of(i);
      common[i] = static_cast<std::uint8_t>(code(v[0]) & code(v[1]) & code(v[2]));
    }
    const hn::ScalableTag<std::uint8_t> d;
    for (std::size_t i = 0; i < mesh_.size; i += hn::Lanes(d)) {
      const std::uint64_t is_left = bits_of(d, hn::Eq(hn::Load(d, common + i), hn::Zero(d)));
      rest[i / 64] |= (is_left & low_bits(mesh_.size - i)) << (i % 64);
    }
  }

  // Loads each vertex with whatever follows it in memory as its fourth lane, except the greatest vertex, which nothing
  // may follow.
  HWY_NOINLINE void skip_by_vertices(const SphereBox<Real>& box, std::uint32_t greatest,
                                     std::uint64_t* rest) const noexcept {
    const D4 d;
    const auto three = [&](const Real* from) HWY_ATTR {
      Real four[4] = {};
      std::memcpy(four, from, 3 * sizeof(Real));
      return hn::LoadU(d, four);
    };
    const auto low = three(box.low), high = three(box.high), last = three(vertex(greatest));
    const auto load = [&](std::uint32_t v) HWY_ATTR { return v == greatest ? last : hn::LoadU(d, vertex(v)); };
    for (std::size_t i = 0; i < mesh_.size; ++i) {
      if (i + prefetched < mesh_.size) {
        const std::uint32_t* next = vertices_of(i + prefetched);
        hwy::Prefetch(vertex(next[0]));
        hwy::Prefetch(vertex(next[1]));
        hwy::Prefetch(vertex(next[2]));
      }
      const std::uint32_t* v = vertices_of(i);
      if (!is_beyond(d, load(v[0]), load(v[1]), load(v[2]), low, high)) set_bit(rest, i);
    }
  }

  // Asks the triangles of `rest`, packed; the others are separated.
  HWY_NOINLINE void ask_the(const std::uint64_t* rest) noexcept {
    std::uint16_t place[mesh_chunk_size];
    std::size_t count = 0;
    for (std::size_t w = 0; w < words(mesh_.size); ++w) {
      answer_.contact[w] = answer_.invalid[w] = 0;
      for (std::uint64_t bits = rest[w]; bits != 0; bits &= bits - 1) {
        place[count++] = static_cast<std::uint16_t>(w * 64 + first_bit(bits));
      }
    }
    outcodes_.are_useful = 2 * count < mesh_.size;
    const auto scatter = [](const std::uint64_t* from, std::uint64_t* to, const std::uint16_t* at, std::size_t size) {
      for (std::size_t w = 0; w < words(size); ++w) {
        for (std::uint64_t bits = from[w]; bits != 0; bits &= bits - 1) {
          set_bit(to, at[w * 64 + first_bit(bits)]);
        }
      }
    };
    ask(
        count, [&](std::size_t i) { return std::size_t{place[i]}; },
        [&](const BlockAnswer& found, std::size_t first, std::size_t size) {
          scatter(found.contact, answer_.contact, place + first, size);
          scatter(found.invalid, answer_.invalid, place + first, size);
        });
  }
  HWY_NOINLINE void ask_all() noexcept {
    ask(
        mesh_.size, [](std::size_t i) { return i; },
        [&](const BlockAnswer& found, std::size_t first, std::size_t size) {
          std::memcpy(answer_.contact + first / 64, found.contact, words(size) * sizeof *found.contact);
          std::memcpy(answer_.invalid + first / 64, found.invalid, words(size) * sizeof *found.invalid);
        });
  }

  // Asks `count` triangles block by block. place(i) is the position of the i-th in the chunk; add(answer, first, size)
  // takes the answers.
  template <class Place, class Add>
  AXISCERT_INLINE void ask(std::size_t count, Place&& place, Add&& add) const noexcept {
    alignas(64) Real column[9][block_size];
    Block<Real> block{{}, 0, true};
    for (std::size_t k = 0; k < 9; ++k) block.column[k] = column[k];
    for (std::size_t k = 9; k < 13; ++k) block.column[k] = mesh_.sphere + (k - 9);
    for (std::size_t first = 0; first < count; first += block_size) {
      block.size = count - first < block_size ? count - first : block_size;
      for (std::size_t i = 0; i < block.size; ++i) {
        const std::uint32_t* v = vertices_of(place(first + i));
        const auto gather = [&](const Real* from, std::size_t k) {  // not loops: -O2 would not unroll them
          column[k][i] = from[0];
          column[k + 1][i] = from[1];
          column[k + 2][i] = from[2];
        };
        gather(vertex(v[0]), 0);
        gather(vertex(v[1]), 3);
        gather(vertex(v[2]), 6);
      }
      BlockAnswer found;
      decide<D, D2>(block, question_, found);
      add(found, first, block.size);
    }
  }

  static constexpr std::size_t prefetched = 32;  // triangles ahead
  const MeshChunk<Real>& mesh_;
  const Question question_;
  Outcodes& outcodes_;
  MeshAnswer& answer_;
};

template <class D, class D2, class D4, class Real = hn::TFromD<D>>
void decide_mesh(const MeshChunk<Real>& mesh, Question question, Outcodes& outcodes, MeshAnswer& answer) noexcept {
  MeshSteps<D, D2, D4>(mesh, question, outcodes, answer).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
