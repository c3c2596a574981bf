#include <fmt/format.h>

#include "cli/commands.h"
#include "fuzz/address.h"
#include "fuzz/query_file.h"
#include "kernel/error.h"

namespace axiscert {
namespace {

// The source that an address names: a family, or the mesh or query file at `path` if it has the right SHA-256.
SourcePtr source_of(const Address& address, const std::string& mesh, const std::string& queries) {
  const bool is_mesh = address.name.starts_with("mesh-"), is_file = address.name.starts_with("queries-");
  if (!is_mesh && !is_file) return family_source(find_family(address.name));
  const std::string& path = is_mesh ? mesh : queries;
  const char* option = is_mesh ? "--mesh" : "--queries";
  if (path.empty()) {
    throw Error(fmt::format("address '{}' is into a file: give it with {} FILE", text(address), option));
  }
  SourcePtr source = is_mesh ? mesh_source(path) : query_file_source(path, address.precision);
  if (source->address_name() != address.name) {
    throw Error(fmt::format("{} {} is {}, the address wants {}", option, path, source->address_name(), address.name));
  }
  return source;
}

template <class Real>
int print_query(const Address& address, const Source& source) {
  if (const auto size = source.fixed_size(address.precision); size && address.position() >= *size) {
    throw Error(
        fmt::format("address '{}': the file has {} queries in {}", text(address), *size, name(address.precision)));
  }
  Query<Real> q;
  source.make(address.seed, address.position(), q);
  fmt::print("{}\n", query_line({text(address), address.precision, q, 0}));
  return exit_done;
}

int make_query(const std::string& given, const std::string& mesh, const std::string& queries) {
  const Address address = parse_address(given);
  const SourcePtr source = source_of(address, mesh, queries);
  if (source->version() != address.version) {
    throw Error(fmt::format("address '{}': {} is at generator version {} here, the address is from version {}", given,
                            source->name(), source->version(), address.version));
  }
  return address.precision == Precision::binary32 ? print_query<float>(address, *source)
                                                  : print_query<double>(address, *source);
}

}  // namespace

void add_query(CLI::App& app, Action& action) {
  struct Options {
    std::string address, mesh, queries;
  };
  auto* command = app.add_subcommand("query", "Make the query of an address again, as a line of a query file");
  auto options = std::make_shared<Options>();
  command->add_option("ADDRESS", options->address, "SEED:NAME:VERSION:PRECISION:UNIT:INDEX")->required();
  command->add_option("--mesh", options->mesh, "the mesh that the address is into");
  command->add_option("--queries", options->queries, "the query file that the address is into");
  command->callback([&action, options] {
    action = [options] { return make_query(options->address, options->mesh, options->queries); };
  });
}

}  // namespace axiscert
