// MuJoCo's box-box function, by its table of collision functions, in double. The description applies to MuJoCo 2.2.2.
//
// A model of two boxes is made once; sizes and places are written into it, which is what a step of it does before it
// asks. The function takes them as they stand, so nothing is rounded on the way.
#include <mujoco/mujoco.h>

#include <cstring>
#include <memory>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {
namespace {

static_assert(sizeof(mjtNum) == 8);

class MujocoBoxes {
 public:
  using Real = double;
  static constexpr std::size_t measure_count = whole_contact;

  MujocoBoxes() {
    static constexpr char scene[] =
        "<mujoco><worldbody>"
        "<body><freejoint/><geom type='box' size='1 1 1'/></body>"
        "<body><freejoint/><geom type='box' size='1 1 1'/></body>"
        "</worldbody></mujoco>";
    static constexpr const char* name = "boxes.xml";
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    if (mj_makeEmptyFileVFS(files.get(), name, sizeof scene - 1) != 0) return;
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], scene, sizeof scene - 1);
    char error[256];
    model_.reset(mj_loadXML(name, files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (model_) data_.reset(mj_makeData(model_.get()));
  }

  int operator()(const Boxes<double>& q, BoxContact<double>& contact) {
    if (!data_) return AXISCERT_UNDECIDED;
    put(q.a, 0);
    put(q.b, 1);
    mjContact found[mjMAXCONPAIR];
    const int count = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX](model_.get(), data_.get(), found, 0, 1, 0);
    for (int i = 0; i < count; ++i) {
      const mjContact& one = found[i];
      if (std::isnan(one.dist)) return AXISCERT_INVALID;
      if (!contact.is_new_deepest(one.dist)) continue;
      // Its point is half way between the two, and its normal goes from the first to the second.
      const Vec3<double> normal = {one.frame[0], one.frame[1], one.frame[2]},
                         middle = {one.pos[0], one.pos[1], one.pos[2]}, half = normal * (one.dist / 2);
      contact = {one.dist, normal, middle - half, middle + half};
    }
    return verdict_of(count > 0);
  }

 private:
  struct Deleted {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  void put(const Box<double>& box, std::size_t geom) {
    const double half[] = {box.half.x, box.half.y, box.half.z}, at[] = {box.centre.x, box.centre.y, box.centre.z};
    for (std::size_t i = 0; i < 3; ++i) {
      model_->geom_size[3 * geom + i] = half[i];
      data_->geom_xpos[3 * geom + i] = at[i];
      for (std::size_t k = 0; k < 3; ++k) data_->geom_xmat[9 * geom + 3 * i + k] = row(box, i, k);
    }
  }

  std::unique_ptr<mjModel, Deleted> model_;
  std::unique_ptr<mjData, Deleted> data_;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::MujocoBoxes>(
      index,
      {"mujoco", "MuJoCo's function of two boxes, margin 0, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
