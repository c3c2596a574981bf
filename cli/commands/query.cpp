#include <fmt/format.h>

#include <filesystem>

#include "cli/options/address_query.h"
#include "cli/commands.h"
#include "kernel/base/error.h"

namespace axiscert {

void add_query(CLI::App& app, Action& action) {
  struct Options {
    std::string address;
    AddressFiles files;
  };
  auto* command = app.add_subcommand("query", "Generate the query of an address again, as a line of a query file");
  auto options = std::make_shared<Options>();
  command->add_option("ADDRESS", options->address, "SEED:NAME:VERSION:PRECISION:UNIT:INDEX")->required();
  add_address_files(*command, options->files);
  command->callback([&action, options] {
    action = [options] {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(options->address, ignored)) {
        throw Error(fmt::format("ADDRESS '{}' is a file; `axiscert check {}` reads the queries of one",
                                options->address, options->address));
      }
      fmt::print("{}\n", query_line(query_at(parse_address(options->address), options->files)));
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert
