// A swept parameter as an axis of an instrument's output: its values, the value of each source, and plots against it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/queries/source.h"
#include "fuzz/queries/sweep.h"
#include "fuzz/text/field.h"
#include "fuzz/text/values.h"
#include "kernel/kernel.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

struct SweepData {
  SweepParameter parameter = SweepParameter::offset;
  std::vector<SignedNumber> values;

  static constexpr Field in_data = {
      .name = "sweep", .about = "The swept parameter; absent: there is none.", .may_be_absent = true};
  AXISCERT_FIELDS(SweepData, AXISCERT_FIELD(parameter, "What is changed of the queries."),
                  AXISCERT_FIELD(values, "To which values, one after the other."))
};
inline constexpr Field swept_field = {
    .name = "swept", .about = "The value of the swept parameter; absent: none, or all of them.", .may_be_absent = true};

// The sweep of sources that were swept together; empty where none was.
std::optional<SweepData> sweep_of(const std::vector<SourcePtr>& sources);
// The value at which one source was swept.
std::optional<SignedNumber> swept_value(const Source& source);

std::vector<std::string> ids_of(const std::vector<const Kernel*>& kernels);

struct SweepY {
  double y;
  std::optional<std::pair<double, double>> interval = {};  // drawn as an error bar: of all points, or of none
};

// One line for each of `lines` and each source that was swept, over the values of the parameter that are above 0, on a
// logarithmic axis; y(line, source) empty, or 0 or less: no point. Empty where nothing was swept.
std::optional<InstrumentPlot> sweep_plot(
    const std::vector<SourcePtr>& sources, std::string caption, std::string y_label,
    const std::vector<std::string>& lines,
    const std::function<std::optional<SweepY>(std::size_t line, std::size_t source)>& y,
    InstrumentPlot::Kind kind = InstrumentPlot::Kind::line);

}  // namespace axiscert
