#include "fuzz/campaign/stretch.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

#include "fuzz/text/journal_form.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Of>
std::string encoded(const Of& of) {
  Encoder encoder;
  encoder.put(of);
  return encoder.bytes();
}

// Reports bytes that do not fit as an Error.
template <class Of>
Of decoded(std::string_view bytes, Of into) {
  try {
    Decoder decoder(bytes);
    decoder.get(into);
    decoder.finish();
    return into;
  } catch (const Cbor::exception& wrong) {
    throw Error(std::string("the bytes are not a tally: ") + wrong.what());
  }
}

}  // namespace

std::string encode(const Tally& tally) { return encoded(tally); }
std::string encode(const Costs& costs) { return encoded(costs); }
Tally decode_tally(std::string_view bytes, const Predicate& predicate) {
  return decoded(bytes, empty_tally(predicate));
}
Costs decode_costs(std::string_view bytes) { return decoded(bytes, Costs()); }

namespace {

using Cbor = nlohmann::json;

std::uint64_t cell_queries(const Questions& questions, const CellResult& cell) {
  const Source& source = *questions.sources[cell.source];
  const auto fixed = questions.fixed_size(source, cell.precision);
  return fixed ? *fixed : questions.trials(source, cell.precision);
}

// Not (a + b - 1) / b, which overflows.
std::uint64_t rounded_up(std::uint64_t a, std::uint64_t b) { return a / b + (a % b != 0); }

}  // namespace

std::vector<PlannedCell> planned_cells(const Questions& questions) {
  std::vector<PlannedCell> cells;
  for (const CellResult& cell : cells_of(questions, 0))
    cells.push_back(
        {cell.source, cell.precision, cell_queries(questions, cell), questions.sources[cell.source]->name()});
  return cells;
}

std::uint64_t Stretches::default_units_each(const std::vector<PlannedCell>& cells) {
  std::uint64_t units = 0;
  for (const PlannedCell& cell : cells) units += rounded_up(cell.queries, unit_size);
  // A cell's last stretch may be short: one more stretch for each cell.
  const std::uint64_t least = rounded_up(units, most - std::min<std::uint64_t>(most / 2, cells.size()));
  return std::max({std::uint64_t{1}, std::min(usual_units, units / enough_stretches), least});
}

Stretches::Stretches(std::vector<PlannedCell> cells, std::uint64_t units_each)
    : cells_(std::move(cells)), units_each_(units_each) {
  std::vector<std::uint64_t> counts;
  for (const PlannedCell& cell : cells_) {
    const std::uint64_t units = rounded_up(cell.queries, unit_size);
    counts.push_back(rounded_up(units, units_each));
    units_ += units;
    queries_ += cell.queries;
    count_ += counts.back();
  }
  if (count_ > most) {
    throw Error(
        fmt::format("{} stretches of {} units are more than the {} that a journal supports: give at least {} units "
                    "per stretch",
                    count_, units_each, most, default_units_each(cells_)));
  }
  std::uint64_t number = 0, index = 0;
  while (number < count_) {
    Level& level = levels_.emplace_back(Level{number, index, {}});
    std::uint64_t next = UINT64_MAX;
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
      if (counts[cell] <= index) continue;
      level.cells.push_back(cell);
      next = std::min(next, counts[cell]);
    }
    number += (next - index) * level.cells.size();
    index = next;
  }
}

Stretch Stretches::at(std::uint64_t number) const {
  const auto after = std::upper_bound(levels_.begin(), levels_.end(), number,
                                      [](std::uint64_t n, const Level& level) { return n < level.first_number; });
  const Level& level = *std::prev(after);
  const std::uint64_t past = number - level.first_number;
  const std::size_t cell = level.cells[past % level.cells.size()];
  const std::uint64_t first_unit = (level.first_index + past / level.cells.size()) * units_each_;
  const auto& [source, precision, queries, family] = cells_[cell];
  const std::uint64_t left = queries - first_unit * unit_size;
  return {cell, source, precision, first_unit, units_each_ > left / unit_size ? left : units_each_ * unit_size};
}

namespace {
std::string range_text(std::uint64_t first, std::uint64_t last) {
  return first == last ? std::to_string(first) : fmt::format("{} to {}", first, last);
}
}  // namespace

std::string Stretches::cell_text(std::size_t cell) const {
  return fmt::format("{} {}", cells_[cell].family, name(cells_[cell].precision));
}

std::string Stretches::text(std::uint64_t number) const {
  const Stretch s = at(number);
  return fmt::format("{}, unit{} {}", cell_text(s.cell), s.units() == 1 ? "" : "s",
                     range_text(s.first_unit, s.first_unit + s.units() - 1));
}

std::string Stretches::text(const std::vector<std::uint64_t>& numbers, std::size_t limit) const {
  std::map<std::size_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> ranges;  // [first, end) by cell
  for (const std::uint64_t number : numbers) {
    const Stretch s = at(number);
    auto& of_cell = ranges[s.cell];
    if (!of_cell.empty() && of_cell.back().second == s.first_unit) of_cell.back().second += s.units();
    else of_cell.emplace_back(s.first_unit, s.first_unit + s.units());
  }
  std::string all;
  std::size_t parts = 0;
  for (const auto& [cell, of_cell] : ranges) {
    if (parts < limit) all += fmt::format("{}{}: units", all.empty() ? "" : "; ", cell_text(cell));
    for (std::size_t i = 0; i < of_cell.size(); ++i) {
      if (parts++ < limit) all += (i == 0 ? " " : ", ") + range_text(of_cell[i].first, of_cell[i].second - 1);
    }
  }
  return parts > limit ? fmt::format("{} and {} more parts", all, parts - limit) : all;
}

CampaignResult planned(const Questions& questions) {
  CampaignResult result{.cells = cells_of(questions, 0)};
  for (CellResult& cell : result.cells) cell.queries = cell_queries(questions, cell);
  return result;
}

std::string encode(const Entry& entry) {
  const auto binary = [](const std::string& bytes) {
    return Cbor::binary({reinterpret_cast<const std::uint8_t*>(bytes.data()),
                         reinterpret_cast<const std::uint8_t*>(bytes.data()) + bytes.size()});
  };
  Cbor json = {entry.stretch, Cbor::array(), binary(entry.costs)};
  for (const std::string& tally : entry.tallies) json[1].push_back(binary(tally));
  std::string bytes;
  Cbor::to_cbor(json, bytes);
  return bytes;
}

Entry decode_entry(std::string_view bytes) {
  const auto text = [](const Cbor& binary) {
    const auto& content = binary.get_binary();
    return std::string(content.begin(), content.end());
  };
  try {
    const Cbor json = Cbor::from_cbor(bytes);
    Entry entry{whole_number<std::uint64_t>(json.at(0)), {}, text(json.at(2))};
    for (const Cbor& tally : json.at(1)) entry.tallies.push_back(text(tally));
    return entry;
  } catch (const Cbor::exception& wrong) {
    throw Error(std::string("the bytes are not a finished stretch: ") + wrong.what());
  }
}

Entry run_stretch(const Plan& plan, const Stretches& stretches, std::uint64_t number) {
  const Stretch stretch = stretches.at(number);
  const Source& source = *plan.questions.sources[stretch.source];
  std::vector<Tally> tallies(plan.answerers.kernels.size(), empty_tally(source.predicate()));
  Costs costs;
  std::vector<StandingLeaders> standing;
  for (std::uint64_t done = 0; done < stretch.queries; done += unit_size) {
    const UnitResult unit = run_unit(plan, source, stretch.precision, stretch.first_unit + done / unit_size,
                                     std::min(unit_size, stretch.queries - done), standing);
    standing.clear();
    for (std::size_t k = 0; k < tallies.size(); ++k) {
      tallies[k].merge(unit.tallies[k]);
      standing.push_back(standing_of(tallies[k]));
    }
    costs.core_seconds += unit.core_seconds;
    costs.second_opinions += unit.second_opinions;
    costs.steps.merge(unit.steps);
  }
  Entry entry{number, {}, encode(costs)};
  for (const Tally& tally : tallies) entry.tallies.push_back(encode(tally));
  return entry;
}

}  // namespace axiscert
