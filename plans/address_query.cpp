#include "plans/address_query.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "fuzz/files/corpus.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/sweep.h"
#include "kernel/base/error.h"
#include "plans/predicate_options.h"

namespace axiscert {
namespace {

const Family& family_of(const Address& address, std::string_view name) {
  try {
    return find_family(name);
  } catch (const Error& unknown) {
    throw Error(fmt::format("address '{}': {}", text(address), unknown.what()));
  }
}

// The corpus's queries of the predicate and entry that have this address; of the default predicate where none have.
SourcePtr corpus_of(const Address& address, const std::string& folder) {
  for (const Predicate* predicate : predicates()) {
    for (std::size_t entry = 0; entry < predicate->entries.size(); ++entry) {
      try {
        if (SourcePtr source = corpus_source(folder, *predicate, entry); source->address_name() == address.name)
          return source;
      } catch (const Error&) {  // none of this entry
      }
    }
  }
  return corpus_source(folder, default_predicate());
}

// The part of a query file that has this address; the first where none has.
SourcePtr part_named(const std::string& path, const Address& address) {
  const std::vector<SourcePtr> parts = query_file_sources(path, address.precision);
  const auto named =
      std::ranges::find_if(parts, [&](const SourcePtr& part) { return part->address_name() == address.name; });
  return named == parts.end() ? parts.front() : *named;
}

// The source that an address names, `own_name` without a swept value: a family, or the given file if its SHA-256 is the
// address's.
SourcePtr unswept_source_of(const Address& given, std::string_view own_name, const AddressFiles& files) {
  Address address = given;
  address.name = own_name;
  // A mesh has queries of several predicates, [PREDICATE/]mesh-SHA256.
  const Predicate* predicate = nullptr;
  std::string_view name = address.name;
  for (const Predicate* other : mesh_predicates()) {
    const std::string own = id_prefix(*other);
    if (!name.starts_with(own + "mesh-")) continue;
    predicate = other;
    name.remove_prefix(own.size());
    break;
  }
  const auto is_into = [&](const char* kind) { return name.starts_with(kind); };
  const bool is_mesh = predicate != nullptr, is_corpus = is_into("corpus-");
  if (!is_mesh && !is_corpus && !is_into("queries-")) return family_source(family_of(given, address.name));
  const std::string& path = is_mesh ? files.mesh : is_corpus ? files.corpus : files.queries;
  const char* option = is_mesh ? "--mesh" : is_corpus ? "--corpus" : "--queries";
  if (path.empty() && !is_corpus) {
    throw Error(fmt::format("address '{}' is in a file: give that file with {} FILE", text(address), option));
  }
  const std::string place = is_corpus && path.empty() ? default_corpus_folder() : path;
  const SourcePtr source = is_mesh     ? mesh_source(place, *predicate)
                           : is_corpus ? corpus_of(address, place)
                                       : part_named(place, address);
  if (source->address_name() != address.name) {
    throw Error(
        fmt::format("{} {} is {}, but the address names {}", option, place, source->address_name(), address.name));
  }
  return source;
}

// With the value of a swept parameter that the address names.
SourcePtr source_of(const Address& address, const AddressFiles& files) {
  const auto [own_name, point] = split_swept(address.name);
  const SourcePtr source = unswept_source_of(address, own_name, files);
  if (!point) return source;
  require_within({point->parameter, {*point}}, address.precision);
  return swept_source(source, *point);
}

// The source, which makes what the address says.
SourcePtr same_source_of(const Address& address, const AddressFiles& files) {
  SourcePtr source = source_of(address, files);
  if (source->version() != address.version) {
    throw Error(fmt::format("address '{}': {} has generator version {} here, but the address is from version {}",
                            text(address), source->name(), source->version(), address.version));
  }
  return source;
}

void require_in(const Source& source, const Address& address) {
  if (const auto size = source.fixed_size(address.precision); size && address.position() >= *size) {
    throw Error(
        fmt::format("address '{}': the file has {} queries in {}", text(address), *size, name(address.precision)));
  }
}

template <class Real>
Numbers<Real> make_query(const Address& address, const Source& source) {
  require_in(source, address);
  return source.make<Real>(address.seed, address.position());
}

}  // namespace

bool is_address(const std::string& text) {
  std::error_code ignored;
  const bool is_witness =
      text.size() > 1 && text.front() == 'w' && text.find_first_not_of("0123456789", 1) == text.npos;
  return (text.find(':') != text.npos || is_witness) && !std::filesystem::exists(text, ignored);
}

QueryRange query_range(const std::string& text, const AddressFiles& files) {
  const std::size_t colon = text.rfind(':'), dash = text.find('-', colon);
  const std::string unit = text.substr(0, colon + 1);
  Address first{}, last{};
  try {
    first = parse_address(text.substr(0, dash));
    last = dash == text.npos ? first : parse_address(unit + text.substr(dash + 1));
  } catch (const Error& wrong) {
    if (dash == text.npos) throw;
    throw Error(fmt::format("range '{}', FIRST-LAST in the place of INDEX: {}", text, wrong.what()));
  }
  if (first.index > last.index) {
    throw Error(fmt::format("range '{}': FIRST {} is greater than LAST {}; give {}{}-{}", text, first.index, last.index,
                            unit, last.index, first.index));
  }
  SourcePtr source = same_source_of(first, files);
  require_in(*source, last);
  return {first, last.index - first.index + 1, std::move(source)};
}

std::vector<StoredQuery> queries_given(const std::vector<std::string>& given, const std::string& csv_precision,
                                       const AddressFiles& files) {
  std::vector<StoredQuery> all;
  for (const std::string& each : given) {
    if (std::count(each.begin(), each.end(), ':') == 5) {
      all.push_back(query_at(parse_address(each), files));
      continue;
    }
    if (is_address(each)) parse_address(each);  // which says what
    for (StoredQuery& stored : read_query_file(each, parse_precision(csv_precision))) all.push_back(std::move(stored));
  }
  return all;
}

StoredQuery query_at(const Address& address, const AddressFiles& files) {
  const SourcePtr source = same_source_of(address, files);
  StoredQuery stored{text(address), address.precision, {}, &source->predicate(), source->entry(), 0, text(address)};
  if (address.precision == Precision::binary32) stored.numbers = make_query<float>(address, *source);
  else stored.numbers = make_query<double>(address, *source);
  return stored;
}

}  // namespace axiscert
