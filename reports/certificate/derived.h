// The record that a certificate carries: its plan, the kernels with their promises, the counts of all stretches added
// up, and the findings; without witnesses, and without what no level reads.
#pragma once

#include <string>

#include "fuzz/campaign/stretch.h"
#include "fuzz/record/record.h"
#include "reports/certificate/certificate_data.h"

namespace axiscert {
// The parts of a certificate's materials that a run's record gives: its entries, whose families have only what is not
// counted by stretch, and its findings. The first kernel is called "kernel", as in its plan.
std::vector<KernelMaterial> kernels_of_record(const Record& record);
std::vector<FindingMaterial> findings_of_record(const Record& record);

// The stretches of a certificate's plan, from the numbers in it. Throws NotValid, which begins with `name`.
Stretches stretches_of(const CertificatePredicate& predicate, const std::string& name);
// Throws NotValid where they are not as long as `certify` makes them.
void require_usual_stretches(const CertificatePredicate& predicate, const std::string& name);

// The record, made of the predicate's members `kernel` and `materials`. Throws NotValid, which begins with `name`, for
// stretches that are missing, doubled or of another size, and for counts that contradict each other or the plan.
Record reduced_record(const CertificatePredicate& predicate, const std::string& name);

// Members that follow from the materials of a certificate: `certify` states them, and `verify` finds them again.

// The predicate with the members that follow from its others made anew: `kernel` (its promise and precisions), `asked`,
// `levels`, `comparison`, `situations`, `breaks_first` and `limits`. `record` is the reduced one.
//
// A link as the cause of what breaks first is known of a witness alone: then another, or nothing, comes out here.
CertificatePredicate derived_predicate(CertificatePredicate predicate, const Record& record);

// Whether the sources that made it are those of this axiscert.
bool is_made_by_this(const CertificatePredicate& predicate);

// Holds a predicate to its materials, and returns the reduced record. Throws NotValid, which begins with `name`, for
// the first thing that is stated otherwise, by name. The sentences of another axiscert are not compared.
Record require_derived(const CertificatePredicate& predicate, const std::string& name);

// Whether the kernel called a promised query separated or contact in every precision in which it was asked.
bool has_answers(const Record& record, const std::string& kernel);

// Whether the numbers of queries are those of the stated effort and kind of kernel. Throws NotValid, which begins with
// `name`.
void require_effort(const CertificatePredicate& predicate, const std::string& name);

}  // namespace axiscert
