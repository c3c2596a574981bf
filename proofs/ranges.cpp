#include "proofs/ranges.h"

#include <array>

namespace axiscert::proofs {
namespace {

// The three edges have the ranges of the first.
constexpr auto table = std::to_array<Range>({
    // clang-format off
    {Domain::scaled, "V",  true,  "-4",  "4",    "12", 0, "V", "y0 z0 y1 z1 y2 z2"},
    {Domain::scaled, "d",  false, "-4",  "4",    "18", 0, "d", "x0 y0 z0 x1 y1 z1 x2 y2 z2"},
    {Domain::scaled, "N1", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "N2", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "N3", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "d1", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "d2", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "d3", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q1", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q2", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q3", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "QC", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::scaled, "QA", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::scaled, "QB", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::absolute, "V",  true,  "-4",  "4",  "", 0, "", ""},
    {Domain::absolute, "d",  false, "-16", "16", "", 0, "", ""},
    {Domain::absolute, "N1", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "N2", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "N3", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "d1", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "d2", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "d3", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "Q1", true,  "-16", "16", "", 4157, "", ""},
    {Domain::absolute, "Q2", true,  "-16", "16", "", 4157, "", ""},
    {Domain::absolute, "Q3", true,  "-16", "16", "", 4157, "", ""},
    // clang-format on
});

}  // namespace

std::span<const Range> ranges() { return table; }

}  // namespace axiscert::proofs
