// The manifest of a program that is a kernel, and its lines of code in any language, with places for the numbers of a
// query, by which its engine is asked one query by hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/predicate.h"

namespace axiscert::plugin {
// The places that code for queries of this entry may have: "ax" for a column, and "a" for the columns of a group, with
// commas between them.
std::vector<std::string> places_of(const PredicateEntry& entry);

// The first place of a line, without its braces, that is not among `known`; empty where there is none. A place is small
// letters alone between braces, as {ax}: braces of the language itself have anything else, or a space, beside them.
std::string unknown_place(std::string_view line, const std::vector<std::string>& known);

// The lines, one below the other, with the numbers in their places; `numbers` has one text for each column of the
// entry. A place that the entry does not have stays as it is.
std::string filled_code(const std::vector<std::string>& lines, const PredicateEntry& entry,
                        const std::vector<std::string>& numbers);

// The manifest of a program that is a kernel: JSON, by which it says what it is called, what it answers and how it is
// started. docs/plugins.md has its members.

inline constexpr std::string_view manifest_format = "axiscert-program/2";

struct Manifest {
  std::string name;
  std::vector<std::string> command;  // the program and its arguments; run in the manifest's folder
  std::vector<Precision> precisions;
  std::string predicate, entry;          // empty: the first
  Exposure exposes = Exposure::verdict;  // verdicts, or also comparison bits
  std::size_t measures = 0;              // so many of the predicate's measures follow each reply
  TouchingPolicy touching = TouchingPolicy::contact;
  Limits limits = {};
  MotionPolicy motion = {};
  bool may_decline = false;                            // `undecided` is an answer that it may give
  std::string conforms_to, formulae, summary, source;  // as in plugin.h; empty: none
  std::string package, version;                        // of what it asks, where that has them
  // Asks it one query by hand, in its own language, with places for the numbers; none: not stated.
  std::vector<std::string> code;
  std::vector<std::string> files;  // others that its answers depend on, from the manifest's folder; in the digests
};

// Throws Error that begins with `name`, in one line, for anything else. Nothing is opened or started.
Manifest read_manifest(std::string_view text, const std::string& name);

}  // namespace axiscert::plugin
