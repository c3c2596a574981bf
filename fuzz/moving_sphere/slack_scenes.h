// Scenes of slacks of the moving sphere.
#pragma once

#include "fuzz/slack/scenes.h"

namespace axiscert {

extern const SlackScenes moving_sphere_slack_scenes;

}  // namespace axiscert
