#include "plans/given_queries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "fuzz/files/corpus.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/sweep.h"
#include "kernel/base/error.h"
#include "plans/notices.h"
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

std::string QueryPart::folder() const {
  return entry == 0 ? std::string(predicate->id) : fmt::format("{}-{}", predicate->id, predicate->entries[entry].name);
}

std::vector<QueryPart> query_parts(const std::vector<std::string>& files, Precision csv_precision,
                                   const std::string& predicate, const std::vector<std::string>& kernels) {
  std::vector<QueryPart> parts;
  std::vector<std::string> texts;
  for (const std::string& file : files) {
    const std::vector<SourcePtr> sources = query_file_sources(file, csv_precision);
    texts.push_back(fmt::format("{}: {}", file == "-" ? "stdin" : file, parts_text(counts_of(sources))));
    for (const SourcePtr& source : sources) {
      if (!predicate.empty() && source->predicate().id != predicate) continue;
      const bool is_there = std::ranges::any_of(parts, [&](const QueryPart& part) {
        return part.predicate == &source->predicate() && part.entry == source->entry();
      });
      if (!is_there) parts.push_back({&source->predicate(), source->entry(), {}});
    }
  }
  if (parts.size() < 2) return parts;
  const std::string there = fmt::format("{}", fmt::join(texts, "; "));
  for (const std::string& id : kernels) {
    const Kernel& kernel = find_kernel(id);
    const auto part = std::ranges::find_if(parts, [&](const QueryPart& other) {
      return other.predicate == kernel.predicate && other.entry == kernel.entry;
    });
    if (part == parts.end()) {
      throw Error(fmt::format("--kernel {}: it is of {}; {}", id, part_text(*kernel.predicate, kernel.entry), there));
    }
    part->kernels.push_back(id);
  }
  for (const QueryPart& part : parts) {
    if (kernels.empty() || !part.kernels.empty()) continue;
    throw Error(
        fmt::format("no kernel is given for the queries of {}; {}; add one with --kernel, or give none: then "
                    "each part is judged by the first of its predicate",
                    part_text(*part.predicate, part.entry), there));
  }
  notice("{}", there);
  return parts;
}

void require_one_of_each(std::span<const Kernel* const> given) {
  for (const Kernel* kernel : given) {
    for (const Kernel* other : given) {
      if (other == kernel) break;
      if (other->predicate != kernel->predicate || other->entry != kernel->entry) continue;
      throw Error(fmt::format("--kernel {} and {}: the queries of a file are judged by one kernel of their predicate",
                              other->id, kernel->id));
    }
  }
}

const Kernel& kernel_for_query(std::span<const Kernel* const> given, const Predicate& predicate, std::size_t entry,
                               std::string_view what) {
  const auto found = std::ranges::find_if(
      given, [&](const Kernel* kernel) { return kernel->predicate == &predicate && kernel->entry == entry; });
  if (found != given.end()) return **found;
  if (given.empty()) return default_kernel(predicate, entry);
  std::vector<std::string> texts;
  for (const Kernel* kernel : given)
    texts.push_back(fmt::format("{} of {}", kernel->id, part_text(*kernel->predicate, kernel->entry)));
  throw Error(fmt::format("{} is of {}, and no kernel of it is given: {}", what, part_text(predicate, entry),
                          fmt::join(texts, ", ")));
}

}  // namespace axiscert
