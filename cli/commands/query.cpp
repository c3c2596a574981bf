#include <fmt/format.h>

#include "cli/options/address_query.h"
#include "cli/commands.h"

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
      fmt::print("{}\n", query_line(query_at(parse_address(options->address), options->files)));
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert
