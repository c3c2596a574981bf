#include "kernel/boxes/contact.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/boxes/simd.h"
#include "kernel/boxes/slips.h"
#include "kernel/boxes/textbook.h"
#include "kernel/boxes/thirteen.h"
#include "kernel/boxes/turned.h"
#include "kernel/permitted/graph.h"

namespace axiscert {

std::vector<Kernel> box_box_kernels();

namespace {

using namespace boxes;

template <class F>
Kernel of_matrices(std::string_view summary) {
  return formulae_kernel<MatrixBoxes, F>("box-box/" + std::string(F::name), std::string(summary));
}

// It claims the textbook's verdicts, and shows no comparisons, since it does not make all of them.
Kernel early_textbook() {
  Kernel kernel = method_kernel<MatrixBoxes, EarlyTextbook>(
      "box-box/textbook-early", "textbook, until one axis separates, in the order a0 b0 a1 a2 b1 b2 and the edges");
  kernel.formulae = Textbook::name;
  kernel.is_reference = true;
  return kernel;
}

template <class F>
Kernel of_quaternions(std::string id, std::string summary) {
  return formulae_kernel<QuaternionBoxes, F>(std::move(id), std::move(summary));
}
template <class F, class Formulae = ByMatrices<F>>
Kernel turned() {
  return of_quaternions<Formulae>("box-box/" + std::string(F::name) + "-turned",
                                  std::string(F::name) + ", each quaternion turned into a matrix");
}

template <class F>
Kernel of_corners(std::string_view summary) {
  return formulae_kernel<MinmaxBoxes, F>("box-box/" + std::string(F::name) + "-minmax", std::string(summary));
}

template <class F, class Formulae = ByMatrices<F>>
Kernel of_both() {
  return formulae_kernel<MixedBoxes, Formulae>("box-box/" + std::string(F::name) + "-mixed",
                                               std::string(F::name) + ", A by two corners and B by a quaternion");
}

}  // namespace

std::vector<Kernel> box_box_kernels() {
  return {
      of_matrices<ProjectedFifteen>("fifteen axes, products of the boxes' own vectors, all six terms (Larcombe, 1995)"),
      of_matrices<Columns>("the same, a column for the normal of a facet"),
      of_matrices<DroppedFifteen>("then without the terms that are 0 for orthogonal columns"),
      of_matrices<FramedFifteen>("then in A's frame, B's columns projected on each axis"),
      with_lane_forms(of_matrices<Textbook>("then entries of R = A'B for determinants, as in books"), simd_textbook),
      early_textbook(),
      of_matrices<Rtcd>("textbook, 2^-23 added to |R|"),
      of_matrices<Gottschalk>("textbook, 1e-6 added to |R|"),
      of_matrices<Bullet>("textbook, on the edges 1e-5 added to |R| and more than 2^-23 asked"),
      with_lane_forms(
          of_matrices<WithContact<Cofactor>>("textbook, cofactors of R for R in B's radius on the edges; no "
                                             "epsilon; numbers by the least of the axes"),
          simd_cofactor),
      formulae_kernel<MatrixBoxes, WithContact<Cofactor, 105>>(
          "box-box/favours-facets",
          "cofactor, and numbers as engines have them: an edge axis has to be less than a facet's by 5%"),
      of_matrices<SlipOfTheBook>("textbook with a slip: t[1] = T.a2 (the book's first printing)"),
      of_matrices<SlipOfTheFrame>("textbook with a slip: T is not turned into A's frame"),
      of_matrices<SlipOfEpsilon>("textbook with a slip: an epsilon of 2^-149, C#'s float.Epsilon"),
      of_matrices<SlipOfOneInterval>("projected with a slip: A's interval twice, and B's never"),
      of_matrices<SlipOfOwnEdges>("projected with a slip: the edges of A against those of A"),
      of_matrices<SlipOfOneEdge>("projected with a slip: a2 x b2 for a1 x b2"),
      turned<ProjectedFifteen>(),
      turned<Columns>(),
      turned<DroppedFifteen>(),
      turned<FramedFifteen>(),
      turned<Textbook>(),
      turned<Rtcd>(),
      turned<Gottschalk>(),
      turned<Bullet>(),
      turned<Cofactor, WithContact<ByMatrices<Cofactor>>>(),
      of_quaternions<Homogeneous>("box-box/homogeneous", "textbook of quaternions, multiplied out: no division"),
      of_corners<Intervals>("the mins and maxes of two upright boxes compared: nothing is rounded"),
      of_corners<ByMatrices<ProjectedFifteen>>("projected, centre and half extents computed of two corners"),
      of_corners<ByMatrices<Textbook>>("textbook, centre and half extents computed of two corners"),
      of_corners<WithContact<ByMatrices<Cofactor>>>("cofactor, centre and half extents computed of two corners"),
      of_both<ProjectedFifteen>(),
      of_both<Textbook>(),
      of_both<Cofactor, WithContact<ByMatrices<Cofactor>>>(),
  };
}

}  // namespace axiscert

namespace axiscert::permitted {

Recorder box_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<boxes::MatrixBoxes, boxes::ProjectedFifteen>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Textbook>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Cofactor>(kernel, found);
  put_recorder<boxes::CentreEntry, boxes::TextbookThirteen>(kernel, found);
  put_recorder<boxes::CentreEntry, boxes::Thirteen>(kernel, found);
  put_recorder<boxes::MinmaxEntry, boxes::TextbookThirteen>(kernel, found);
  put_recorder<boxes::MinmaxEntry, boxes::Thirteen>(kernel, found);
  put_recorder<boxes::OrientedEntry, boxes::FramedThirteen>(kernel, found);
  put_recorder<boxes::OrientedEntry, boxes::Thirteen>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted
