// The parts of the boxes' capabilities, each in a source of its own.
#pragma once

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/confirm/slack_scenes.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert::boxes {

const Quantities& box_box_quantities();
const Quantities& box_triangle_quantities();

}  // namespace axiscert::boxes

namespace axiscert {

const Traits& box_box_traits();
const Traits& box_triangle_traits();

// Scenes of slacks of boxes, which go apart along the one axis that separates them.

extern const SlackScenes box_box_slack_scenes, box_triangle_slack_scenes;

}  // namespace axiscert
