#include "fuzz/confirm/slack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/brackets.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {
namespace {

constexpr double agreeing_factor = 2;    // sizes agree within this factor of their middle
constexpr double seen_above = 10;        // a size is seen above so many times the rounding
constexpr double most_of_length = 0.25;  // of the scene's own length: what is more is no slack, but another answer

using BracketGroup = std::vector<const Bracket*>;

// The length that a size is a part of.
struct Yardstick {
  SlackKind kind;
  std::string_view to;
  double (*length)(const Bracket&);
};
double unit_length(const Bracket&) { return 1; }
template <std::size_t which>
double scene_length(const Bracket& one) {
  return one.scene->lengths[which].length;
}
std::vector<Yardstick> yardsticks_of(const BracketGroup& group) {
  std::vector<Yardstick> all = {{SlackKind::absolute, "the queries' unit", unit_length}};
  const auto& lengths = group.front()->scene->lengths;
  if (!lengths[0].name.empty()) all.push_back({SlackKind::relative, lengths[0].name, scene_length<0>});
  if (!lengths[1].name.empty()) all.push_back({SlackKind::relative, lengths[1].name, scene_length<1>});
  return all;
}

double quantile_of(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

// A slack of a size, by one yardstick.
struct Agreement {
  Yardstick by;
  double sign, middle, spread;
  std::vector<const Bracket*> agreeing;
  std::size_t looked_at;
};

// Whether the answers are off by more than a slack is.
bool is_no_slack(const BracketGroup& group, double sign) {
  std::vector<double> parts;
  for (const Bracket* one : group) {
    const auto& [first, second] = one->scene->lengths;
    if (sign * one->early > seen_above * one->rounding)
      parts.push_back(sign * one->early / (first.length > 0 ? first.length : second.length));
  }
  std::ranges::sort(parts);
  return quantile_of(parts, 0.5) > most_of_length;
}

std::optional<Agreement> agreement_by(const Yardstick& by, const BracketGroup& group) {
  const auto is_seen = [&](const Bracket& one) {
    return by.length(one) > 0 && std::abs(one.early) > seen_above * one.rounding;
  };
  std::size_t early = 0, late = 0;
  for (const Bracket* one : group) {
    if (is_seen(*one)) ++(one->early > 0 ? early : late);
  }
  const double sign = early >= late ? 1 : -1;
  std::vector<double> sizes;
  for (const Bracket* one : group) {
    if (is_seen(*one) && sign * one->early > 0) sizes.push_back(sign * one->early / by.length(*one));
  }
  if (sizes.size() < least_agreeing || is_no_slack(group, sign)) return std::nullopt;
  std::ranges::sort(sizes);
  Agreement found{by, sign, quantile_of(sizes, 0.5), quantile_of(sizes, 0.9) / quantile_of(sizes, 0.1), {}, 0};
  // All that could show a slack of this size, and how many do.
  std::size_t contrary = 0;
  for (const Bracket* one : group) {
    const double length = by.length(*one), size = sign * one->early / length;
    if (length == 0 || seen_above * one->rounding >= found.middle * length) continue;
    ++found.looked_at;
    contrary += is_seen(*one) && size < 0;
    if (size >= found.middle / agreeing_factor && size <= found.middle * agreeing_factor) found.agreeing.push_back(one);
  }
  const bool is_one = found.looked_at >= least_bracketed && found.agreeing.size() >= least_agreeing &&
                      4 * found.agreeing.size() >= 3 * found.looked_at && 10 * contrary <= found.looked_at;
  return is_one ? std::optional(found) : std::nullopt;
}

// By the yardstick by which the sizes differ least: where two do nearly as well, by the first.
std::optional<Agreement> agreement_of(const BracketGroup& group) {
  std::optional<Agreement> best;
  if (group.size() < least_bracketed) return best;
  for (const Yardstick& by : yardsticks_of(group)) {
    auto one = agreement_by(by, group);
    if (one && (!best || one->spread < 0.9 * best->spread)) best = std::move(one);
  }
  return best;
}

// Half way between the exact turn and the kernel's.
template <class Real>
std::pair<QueryLine, Verdict> witness_of(const Kernel& kernel, const Agreement& found, std::string_view where) {
  const Bracket* shown = found.agreeing.front();
  for (const Bracket* one : found.agreeing) {
    if (one->rounding / std::abs(one->early) < shown->rounding / std::abs(shown->early)) shown = one;
  }
  const Numbers<Real> query = query_at(*shown->scene, static_cast<Real>((1 + shown->turn) / 2));
  return {query_line({fmt::format("slack {}", where), precision_of<Real>, query, kernel.predicate, kernel.entry}),
          found.sign > 0 ? Verdict::contact : Verdict::separated};
}

class Finder {
 public:
  Finder(const Kernel& kernel, Precision precision, const Brackets& brackets)
      : kernel_(kernel), precision_(precision), brackets_(brackets) {}

  // A path's queries together, then by what decides them, then by its single features: a slack is named where most of
  // the queries show it.
  SlacksRecord found() && {
    record_.asked = brackets_.scenes.size();
    record_.bracketed = brackets_.all.size();
    record_.answers = brackets_.answers;
    record_.blind = blind();
    for (const auto& [path, of_path] : groups([](const SlackScene& s) { return s.path; }, everything())) {
      if (add(path_where(path, of_path), of_path)) continue;
      const auto kinds = groups([](const SlackScene& s) { return s.kind; }, of_path);
      for (const auto& [kind, of_kind] : kinds) {
        if (kinds.size() > 1 && add(kind, of_kind)) continue;
        const auto parts = groups([](const SlackScene& s) { return s.part; }, of_kind);
        for (const auto& [part, of_part] : parts) {
          if (parts.size() > 1) add(part, of_part);
        }
      }
    }
    // One size on many queries says the most.
    std::ranges::stable_sort(record_.found, {}, [](const SlackRecord& slack) {
      return std::pair(slack.greatest > 1.25 * slack.least, -static_cast<double>(slack.shown));
    });
    return std::move(record_);
  }

 private:
  using Named = std::vector<std::pair<std::string_view, BracketGroup>>;

  BracketGroup everything() const {
    BracketGroup all;
    for (const Bracket& one : brackets_.all) all.push_back(&one);
    return all;
  }
  template <class NameOf>
  static Named groups(NameOf name_of, const BracketGroup& of) {
    Named found;
    for (const Bracket* one : of) {
      const std::string_view name = name_of(*one->scene);
      auto at = std::ranges::find(found, name, &Named::value_type::first);
      if (at == found.end()) at = found.insert(at, {name, {}});
      at->second.push_back(one);
    }
    return found;
  }
  // The coarsest names of kinds of which enough queries were made, and too few have a turn.
  std::vector<Name> blind() const {
    struct Made {
      std::uint64_t asked = 0, bracketed = 0;
    };
    std::map<std::string_view, Made> made;
    const auto names = [](const SlackScene& scene) { return std::set{scene.path, scene.kind, scene.part}; };
    for (const SlackScene& scene : brackets_.scenes) {
      for (const std::string_view name : names(scene)) ++made[name].asked;
    }
    for (const Bracket& one : brackets_.all) {
      for (const std::string_view name : names(*one.scene)) ++made[name].bracketed;
    }
    std::vector<Name> found;
    for (const SlackScene& scene : brackets_.scenes) {
      for (const std::string_view name : {scene.path, scene.kind, scene.part}) {
        if (made[name].asked < least_bracketed || made[name].bracketed >= least_bracketed) continue;
        if (std::ranges::find(found, Name(name)) == found.end()) found.emplace_back(name);
        break;
      }
    }
    return found;
  }

  static std::string path_where(std::string_view path, const BracketGroup& of) {
    const bool is_one_kind =
        std::ranges::all_of(of, [&](const Bracket* one) { return one->scene->kind == of.front()->scene->kind; });
    return std::string(is_one_kind ? of.front()->scene->kind : path);
  }

  bool add(std::string_view where, const BracketGroup& of) {
    record_.looks.push_back(look(where, of));
    const std::optional<Agreement> one = agreement_of(of);
    if (!one) return false;
    SlackRecord slack;
    slack.kind = one->by.kind;
    slack.to = one->by.to;
    slack.side = one->sign > 0 ? SlackSide::early : SlackSide::late;
    slack.size = one->middle;
    std::vector<double> sizes, lengths;
    for (const Bracket* each : one->agreeing) {
      lengths.push_back(std::abs(each->early));
      sizes.push_back(lengths.back() / one->by.length(*each));
    }
    std::ranges::sort(lengths);
    std::tie(slack.least, slack.greatest) = std::pair(std::ranges::min(sizes), std::ranges::max(sizes));
    slack.in_units = quantile_of(lengths, 0.5);
    slack.shown = one->agreeing.size();
    slack.looked_at = one->looked_at;
    slack.where = where;
    std::tie(slack.witness, slack.said) = precision_ == Precision::binary32 ? witness_of<float>(kernel_, *one, where)
                                                                            : witness_of<double>(kernel_, *one, where);
    record_.found.push_back(std::move(slack));
    return true;
  }

  // The least size that enough of the queries would show, were it there, and the size by which enough of them are off:
  // where there are two lengths, the greater of the first sizes and the less of the second.
  // A margin that the kernel declares hides as much.
  SlackLook look(std::string_view where, const BracketGroup& of) const {
    const double margin = kernel_.limits.margin;
    SlackLook look{where, of.size(), {}, {}, {}, {}};
    if (of.size() < least_bracketed) return look;
    for (const Yardstick& by : yardsticks_of(of)) {
      std::vector<double> least, off;
      for (const Bracket* one : of) {
        if (by.length(*one) == 0) continue;
        least.push_back((seen_above * one->rounding + margin) / by.length(*one));
        if (std::abs(one->early) > seen_above * one->rounding) off.push_back(std::abs(one->early) / by.length(*one));
      }
      if (least.size() < least_bracketed) continue;
      if (off.size() >= least_agreeing) {
        std::ranges::sort(off, std::greater());
        auto& least_off = by.kind == SlackKind::absolute ? look.off_absolute : look.off_relative;
        least_off = std::min(least_off.value_or(INFINITY), off[least_agreeing - 1]);
      }
      std::ranges::sort(least);
      auto& into = by.kind == SlackKind::absolute ? look.least_absolute : look.least_relative;
      const double seen = least[least_bracketed - 1];
      into = into ? std::max(*into, seen) : seen;
    }
    return look;
  }

  const Kernel& kernel_;
  Precision precision_;
  const Brackets& brackets_;
  SlacksRecord record_;
};

template <class Member>
std::optional<double> least_of(const SlacksRecord& slacks, Member member) {
  std::optional<double> least;
  for (const SlackLook& look : slacks.looks) {
    if (look.*member && (!least || *(look.*member) < *least)) least = look.*member;
  }
  return least;
}

}  // namespace

std::optional<SlacksRecord> slacks_of(const Kernel& kernel, Precision precision, std::uint64_t seed,
                                      const std::string& target) {
  if (capabilities_of(*kernel.predicate).slack_scenes == nullptr) return std::nullopt;
  const Brackets brackets = precision == Precision::binary32 ? brackets_of<float>(kernel, seed, target)
                                                             : brackets_of<double>(kernel, seed, target);
  return Finder(kernel, precision, brackets).found();
}

std::optional<double> least_relative(const SlacksRecord& slacks) {
  return least_of(slacks, &SlackLook::least_relative);
}
std::optional<double> least_absolute(const SlacksRecord& slacks) {
  return least_of(slacks, &SlackLook::least_absolute);
}

std::optional<double> off_by(const SlackLook& look, SlackKind kind) {
  return kind == SlackKind::absolute ? look.off_absolute : look.off_relative;
}

const SlackLook* most_off(const SlacksRecord& slacks, SlackKind kind) {
  const SlackLook* most = nullptr;
  for (const SlackLook& look : slacks.looks) {
    if (off_by(look, kind) && (most == nullptr || *off_by(look, kind) > *off_by(*most, kind))) most = &look;
  }
  return most;
}

std::string off_text(const SlackLook& look, SlackKind kind) {
  return fmt::format("{} or more of {} queries {} turn off the exact turn by {:.2g} of {} or more", least_agreeing,
                     look.bracketed, static_cast<const std::string&>(look.where), off_by(look, kind).value(),
                     kind == SlackKind::absolute ? "the queries' unit" : "a length");
}

std::string blind_text(const SlacksRecord& slacks) {
  if (slacks.blind.empty()) return "";
  const std::vector<std::string> kinds(slacks.blind.begin(), slacks.blind.end());
  return fmt::format("the answer turns on fewer than {} of the queries {}", least_bracketed, fmt::join(kinds, ", "));
}

std::string slack_text(const SlackRecord& slack) {
  const bool is_early = slack.side == SlackSide::early;
  const std::string size = slack.kind == SlackKind::absolute ? fmt::format("{:.2g}, an absolute length,", slack.size)
                                                             : fmt::format("{:.2g} of {}", slack.size, slack.to);
  return fmt::format("a slack: contact comes too {} by {} on {} of {} queries {}", is_early ? "early" : "late", size,
                     slack.shown, slack.looked_at, slack.where);
}

std::string no_slack_text(const SlacksRecord& slacks) {
  const std::optional<double> least = least_relative(slacks);
  if (!least) {
    return fmt::format("{} of {} queries could be bracketed: too few to see a slack", slacks.bracketed, slacks.asked);
  }
  return fmt::format("no slack on {} queries whose turn is bracketed; one of {:.2g} of a length would be seen",
                     slacks.bracketed, *least);
}

}  // namespace axiscert
