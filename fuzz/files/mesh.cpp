#include "fuzz/files/mesh.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <span>

#include "exact/numbers/surd.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"

namespace axiscert {
namespace {

static_assert(sizeof(ai_real) == sizeof(float), "assimp built for double would not give the vertices of the file");
static_assert(sizeof(MeshTriangle) == 9 * sizeof(float));

// Messages of the child: a tag, followed by the number of skipped primitives and the triangles, or by an error message.
constexpr char tag_mesh = 'm', tag_error = 'e';

std::span<const aiFace> faces_of(const aiMesh& mesh) { return {mesh.mFaces, mesh.mFaces ? mesh.mNumFaces : 0}; }

// The actual primitive types of the faces, whatever the importer recorded: aiProcess_Triangulate aborts if the two
// differ. Throws if a face names a vertex that the mesh does not have, which assimp would read.
unsigned primitive_types(const aiMesh& mesh) {
  unsigned types = 0;
  for (const aiFace& face : faces_of(mesh)) {
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices || mesh.mVertices == nullptr) {
        throw Error(fmt::format("a face of mesh '{}' names vertex {} of {}", mesh.mName.C_Str(), face.mIndices[k],
                                mesh.mNumVertices));
      }
    }
    switch (face.mNumIndices) {
      case 0:
        break;
      case 1:
        types |= aiPrimitiveType_POINT;
        break;
      case 2:
        types |= aiPrimitiveType_LINE;
        break;
      case 3:
        types |= aiPrimitiveType_TRIANGLE;
        break;
      default:
        types |= aiPrimitiveType_POLYGON;
    }
  }
  // Zero would mean unknown.
  return types != 0 ? types : static_cast<unsigned>(aiPrimitiveType_TRIANGLE);
}

void append(ImportedMesh& out, const aiMesh& mesh) {
  for (const aiFace& face : faces_of(mesh)) {
    MeshTriangle triangle;
    bool usable = face.mNumIndices == 3;
    for (std::size_t k = 0; usable && k < 3; ++k) {
      const aiVector3D& v = mesh.mVertices[face.mIndices[k]];
      triangle[k] = {v.x, v.y, v.z};
      usable = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    }
    if (usable) out.triangles.push_back(triangle);
    else ++out.skipped_primitives;
  }
}

ImportedMesh import_here(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene == nullptr) throw Error(importer.GetErrorString());
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    scene->mMeshes[m]->mPrimitiveTypes = primitive_types(*scene->mMeshes[m]);
  }
  if (scene->mNumMeshes > 0) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr) throw Error(importer.GetErrorString());
  ImportedMesh result;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(result, *scene->mMeshes[m]);
  return result;
}

bool write_all(int to, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(to, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

// Bytes of address space in use: the limit applies to further allocation, whatever a sanitizer has reserved.
std::uint64_t address_space() {
  unsigned long pages = 0;
  if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%lu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void run_child(const std::string& path, const ImportLimits& limits, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int fatal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGXCPU}) std::signal(fatal, SIG_DFL);
  if (const int null = open("/dev/null", O_RDWR); null >= 0) {
    for (const int standard : {0, 1, 2}) dup2(null, standard);
  }
  const rlim_t seconds = limits.seconds, space = address_space() + limits.bytes;
  const rlimit core{0, 0}, processor{seconds, seconds + 5}, memory{space, space};
  setrlimit(RLIMIT_CORE, &core);
  setrlimit(RLIMIT_CPU, &processor);
  setrlimit(RLIMIT_AS, &memory);
  bool sent = false;
  try {
    const ImportedMesh mesh = import_here(path);
    sent = write_all(to, &tag_mesh, 1) && write_all(to, &mesh.skipped_primitives, sizeof mesh.skipped_primitives) &&
           write_all(to, mesh.triangles.data(), mesh.triangles.size() * sizeof(MeshTriangle));
  } catch (const std::exception& wrong) {
    sent = write_all(to, &tag_error, 1) && write_all(to, wrong.what(), std::strlen(wrong.what()));
  } catch (...) {
  }
  _exit(sent ? 0 : 1);
}

std::string read_all(int from) {
  std::string bytes;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t got = read(from, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(got));
  }
}

std::string ending_text(int status, const ImportLimits& limits) {
  if (!WIFSIGNALED(status)) return "assimp ended before it had read the file";
  if (WTERMSIG(status) == SIGXCPU) {
    return fmt::format("assimp was stopped after {} s of processor time", limits.seconds);
  }
  return fmt::format("assimp crashed while reading it ({})", strsignal(WTERMSIG(status)));
}

Error import_error(const std::string& path, std::string reason) {
  if (reason.empty()) reason = "assimp gives no reason";
  return Error(fmt::format("{}: not a mesh that can be read: {}", path, reason));
}

}  // namespace

ImportedMesh import_mesh(const std::string& path, const ImportLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(fmt::format("{}: cannot start assimp: {}", path, std::strerror(errno)));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    run_child(path, limits, ends[1]);
  }
  const int fork_error = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    throw Error(fmt::format("{}: cannot start assimp: {}", path, std::strerror(fork_error)));
  }
  const std::string reply = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw import_error(path, ending_text(status, limits));
  if (reply[0] == tag_error) throw import_error(path, reply.substr(1));

  ImportedMesh mesh;
  const char* at = reply.data() + 1;
  std::memcpy(&mesh.skipped_primitives, at, sizeof mesh.skipped_primitives);
  at += sizeof mesh.skipped_primitives;
  mesh.triangles.resize(static_cast<std::size_t>(reply.data() + reply.size() - at) / sizeof(MeshTriangle));
  if (!mesh.triangles.empty()) std::memcpy(mesh.triangles.data(), at, mesh.triangles.size() * sizeof(MeshTriangle));
  return mesh;
}

namespace {

bool has_zero_area(const MeshTriangle& t) {
  const auto binary = [](const Vec3<float>& v) {
    return Vec3<BinaryNumber>{BinaryNumber(v.x), BinaryNumber(v.y), BinaryNumber(v.z)};
  };
  const Vec3<BinaryNumber> a = binary(t[0]);
  const Vec3<BinaryNumber> normal = portable::cross(binary(t[1]) - a, binary(t[2]) - a);
  return normal.x.is_zero() && normal.y.is_zero() && normal.z.is_zero();
}

double box_diagonal(const std::vector<MeshTriangle>& triangles) {
  const Vec3<float> first = triangles[0][0];
  std::array<float, 3> low = {first.x, first.y, first.z}, high = low;
  for (const MeshTriangle& t : triangles) {
    for (const Vec3<float>& v : t) {
      const std::array<float, 3> at = {v.x, v.y, v.z};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = static_cast<double>(high[k]) - static_cast<double>(low[k]);
    sum = sum + side * side;
  }
  return std::sqrt(sum);
}

class MeshSource final : public Source {
 public:
  MeshSource(const std::string& path, const std::string& bytes, const Predicate& predicate)
      : mesh_(load_mesh(path, bytes.size())), predicate_(predicate), queries_(mesh_queries_of(predicate)) {
    file_.path = path;
    file_.name = base_name(path);
    file_.kind = "mesh";
    file_.sha256 = sha256_hex(std::as_bytes(std::span(bytes)));
    file_.triangles = mesh_.triangles.size();
    file_.degenerate_triangles = mesh_.degenerate_triangles;
    file_.skipped_primitives = mesh_.skipped_primitives;
    generator_ = name_hash(address_name());
    placements_ = name_hash("mesh-" + file_.sha256);
  }

  std::string name() const override { return "mesh/" + file_.name; }
  std::string address_name() const override { return id_prefix(predicate_) + "mesh-" + file_.sha256; }
  std::string purpose() const override { return std::string(queries_.purpose); }
  int version() const override { return queries_.version; }
  std::size_t entry() const override { return queries_.entry; }
  const Predicate& predicate() const override { return predicate_; }
  std::uint64_t base_triangles(Precision, std::uint64_t trials) const override {
    return std::min(trials, file_.triangles);
  }
  std::uint64_t cluster(Precision, std::uint64_t position) const override { return position % file_.triangles; }
  std::size_t cluster_run() const override { return 0; }
  std::optional<FileInfo> file() const override { return file_; }

  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<float>& out) const override {
    queries_.in_binary32(mesh_, placed<float>(seed), own<float>(seed), first, out);
  }
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<double>& out) const override {
    queries_.in_binary64(mesh_, placed<double>(seed), own<double>(seed), first, out);
  }

 private:
  template <class Real>
  StreamName placed(std::uint64_t seed) const {
    return {seed, placements_, placements_version, precision_of<Real>};
  }
  template <class Real>
  StreamName own(std::uint64_t seed) const {
    return {seed, generator_, version(), precision_of<Real>};
  }

  Mesh mesh_;
  const Predicate& predicate_;
  const MeshQueries& queries_;
  FileInfo file_;
  std::uint64_t generator_ = 0, placements_ = 0;  // names of streams, hashed
};

}  // namespace

Mesh load_mesh(const std::string& path, std::uint64_t file_size) {
  ImportedMesh imported = import_mesh(path, limits_for(file_size));
  if (imported.triangles.empty()) {
    throw Error(fmt::format("{}: no triangles in this mesh ({} faces are points, lines or not finite)", path,
                            imported.skipped_primitives));
  }
  Mesh mesh;
  mesh.triangles = std::move(imported.triangles);
  mesh.skipped_primitives = imported.skipped_primitives;
  mesh.degenerate_triangles =
      static_cast<std::uint64_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), has_zero_area));
  mesh.diagonal = box_diagonal(mesh.triangles);
  return mesh;
}

std::vector<const Predicate*> mesh_predicates() {
  std::vector<const Predicate*> served;
  for (const Predicate* predicate : predicates()) {
    if (capabilities_of(*predicate).mesh != nullptr) served.push_back(predicate);
  }
  return served;
}

const MeshQueries& mesh_queries_of(const Predicate& predicate) {
  const MeshQueries* const queries = capabilities_of(predicate).mesh;
  if (queries == nullptr) throw Error(fmt::format("a mesh has no queries of the predicate {}", predicate.id));
  return *queries;
}

SourcePtr mesh_source(const std::string& path, const Predicate& predicate) {
  return std::make_shared<MeshSource>(path, read_bytes(path), predicate);
}

}  // namespace axiscert
