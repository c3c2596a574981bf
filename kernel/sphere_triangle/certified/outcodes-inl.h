// The faces of the sphere's box that the vertices of a mesh are beyond: one bit per face, computed for neighbours in
// memory together. No include guard: included once for each of Highway's instruction sets, after box_step-inl.h.
#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

struct VertexRange {
  std::uint32_t first, end;
};

// A window of the vertices, which moves with the triangles asked.
template <class D>
class OutcodeStep {
 public:
  using Real = hn::TFromD<D>;
  using V = hn::Vec<D>;

  AXISCERT_INLINE OutcodeStep(const MeshChunk<Real>& mesh, const SphereBox<Real>& box, Outcodes& outcodes)
      : mesh_(mesh), box_(box), known_(outcodes) {}

  // Computes the codes of the vertices in `range` that the table lacks. False if the table is too small, or if they are
  // too many for the number of triangles in the chunk.
  AXISCERT_INLINE bool has(VertexRange range) {
    if (range.first <= known_.end && range.end >= known_.first) {  // grows the window if there is room
      const VertexRange both{std::min(range.first, known_.first), std::max(range.end, known_.end)};
      if (both.end - both.first <= sizeof known_.code) range = both;
    }
    VertexRange kept{std::max(range.first, known_.first), std::min(range.end, known_.end)};
    if (kept.end < kept.first) kept = {range.first, range.first};
    const std::size_t size = range.end - range.first, missing = size - (kept.end - kept.first);
    if (size > sizeof known_.code || missing > most_a_triangle * mesh_.size) return false;
    if (kept.end != kept.first && range.first != known_.first) {
      std::memmove(known_.code + (kept.first - range.first), known_.code + (kept.first - known_.first),
                   kept.end - kept.first);
    }
    known_.first = range.first;
    known_.end = range.end;
    compute(range.first, kept.first);
    compute(kept.end, range.end);
    return true;
  }

  // The faces that all vertices of the range are beyond.
  AXISCERT_INLINE unsigned common(VertexRange range) const {
    const std::uint8_t* code = known_.code + (range.first - known_.first);
    const std::size_t size = range.end - range.first;
    std::uint64_t all = ~std::uint64_t{0}, eight;
    std::size_t i = 0;
    for (; i + sizeof eight <= size; i += sizeof eight) {
      std::memcpy(&eight, code + i, sizeof eight);
      all &= eight;
    }
    for (int half = 32; half >= 8; half /= 2) all &= all >> half;
    for (; i < size; ++i) all &= code[i];
    return all & 0xff;
  }

 private:
  static constexpr std::size_t lanes = hn::MaxLanes(D()), most_a_triangle = 8;
  using Bytes = hn::Rebind<std::uint8_t, D>;

  AXISCERT_INLINE void compute(std::size_t v, std::size_t end) {
    const D d;
    std::uint8_t* code = known_.code + (v - known_.first);
    V x, y, z, w;
    if (mesh_.stride == 3) {
      for (; v + lanes <= end; v += lanes, code += lanes) {
        hn::LoadInterleaved3(d, mesh_.vertices + 3 * v, x, y, z);
        hn::StoreU(outcodes_of(d, box_, x, y, z), Bytes(), code);
      }
    } else if (mesh_.stride == 4) {  // the last vertex may have no fourth number
      for (; v + lanes < end; v += lanes, code += lanes) {
        hn::LoadInterleaved4(d, mesh_.vertices + 4 * v, x, y, z, w);
        hn::StoreU(outcodes_of(d, box_, x, y, z), Bytes(), code);
      }
    }
    for (; v < end; v += lanes, code += lanes) {
      const std::size_t count = end - v < lanes ? end - v : lanes;
      alignas(64) Real column[3][lanes] = {};
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) column[k][i] = mesh_.vertices[(v + i) * mesh_.stride + k];
      }
      alignas(64) std::uint8_t bytes[lanes];
      hn::Store(outcodes_of(d, box_, hn::Load(d, column[0]), hn::Load(d, column[1]), hn::Load(d, column[2])), Bytes(),
                bytes);
      std::memcpy(code, bytes, count);
    }
  }

  const MeshChunk<Real>& mesh_;
  const SphereBox<Real>& box_;
  Outcodes& known_;
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
