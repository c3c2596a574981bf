// The parts of the moving sphere's capabilities, each in a source of its own.
#pragma once

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/confirm/slack_scenes.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert::moving_sphere {

const Quantities& quantities();

}  // namespace axiscert::moving_sphere

namespace axiscert {

const Traits& moving_sphere_traits();

extern const SlackScenes moving_sphere_slack_scenes;

}  // namespace axiscert
