// A picture of a map while it is being drawn, and the class of a pixel by what is known of it.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/map/map.h"

namespace axiscert {

// The content of one pixel of one picture.
struct Shown {
  bool yes, tie, certain;
  std::optional<bool> said;   // empty: the kernel gave no such answer
  std::optional<bool> right;  // empty: neither answer is wrong
  bool not_finite = false;
  Verdict answer = Verdict::unanswered;  // the verdict, which says why `said` is empty
  bool outside = false;                  // of the kernel's limits
};
PixelClass class_of(const Shown& shown);

// A verdict in the form of an answer: whether it is `separated`; empty where it is neither that nor contact.
std::optional<bool> said_by(const Outcome& said);

// The classes of a picture, and for each pixel whether the exact answer is yes.
struct Canvas {
  std::vector<PixelClass> pixels;
  std::vector<char> yes;

  void put(std::size_t pixel, const Shown& shown) {
    pixels[pixel] = class_of(shown);
    yes[pixel] = static_cast<char>(shown.yes);
  }
};

// A new foreign process is begun for each block, as for a unit of a run.
inline constexpr std::size_t block_pixels = std::size_t{1} << 14, batch_pixels = 256;

// Draws a map of a test without filters: every pixel by its oracles, and nothing is uncertain.
void draw_by_oracles(const MapPlan& plan, std::vector<Canvas>& canvases, const ShowProgress& report);

}  // namespace axiscert
