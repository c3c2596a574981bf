// The identity of a kernel, by which two runs know it, and of a plan's queries. A kernel's id in a record is what was
// given on the command line, with the path of a plug-in; the name that a plug-in declares stays the same when its file
// is moved or renamed.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/record/plan_record.h"
#include "fuzz/record/record.h"

namespace axiscert {
// By id, for all kernels of a record's plan: "plugin/NAME" for a plug-in that declares NAME, and its id for any other
// kernel: one that comes with axiscert, one that could not be loaded, and plug-ins of one run that declare the same
// name.
using Identities = std::map<std::string, std::string>;
Identities identities_of(const Record& record);

// The same for two records that are compared: equal texts mean the same kernel. Where one of the two has a name twice,
// those who declare it are known by their ids.
std::pair<Identities, Identities> identities_of(const Record& before, const Record& after);

// The entries of a kernel in a record, one for each precision in which it was run.
std::vector<const KernelRecord*> precision_entries(const Record& record, const std::string& id);
// That of one precision; null where there is none.
const KernelRecord* precision_entry(const Record& record, const std::string& id, Precision precision);

// The digests of a kernel's files in a record; empty where it has none, or the record does not have the kernel.
using Digests = std::vector<DigestRecord>;
Digests digests_of(const Record& record, const std::string& id);
// The name that a kernel of the record declares; empty where it declares none.
std::string declared_name(const Record& record, const std::string& id);

// Which files have other bytes: "its plugin was SHA-256 0123456789ab..., and is 89abcdef0123...". Empty where the
// digests are equal, or there are none in one.
std::string digest_change(const Digests& before, const Digests& after);

// The queries that the figures of a record are about, as its plan tells them: equal fingerprints, equal queries.

// The first 16 hex digits of the SHA-256 of a text.
std::string short_sha256(const std::string& text);

// The settings that decide over which queries a family's cell was counted: seed or file, generator, trials. Null where
// the number of queries depended on time. Equal texts mean equal queries.
Json queries_of(const PlanRecord& plan, const std::string& family, Precision precision);
// 16 hex digits over all families and tolerances of a plan, not over its kernels. Empty where the run depended on time.
std::string plan_fingerprint(const PlanRecord& plan);

}  // namespace axiscert
