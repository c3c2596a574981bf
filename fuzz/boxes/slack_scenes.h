// Scenes of slacks of boxes, which go apart along the one axis that separates them.
#pragma once

#include "fuzz/slack/scenes.h"

namespace axiscert {

extern const SlackScenes box_box_slack_scenes, box_triangle_slack_scenes;

}  // namespace axiscert
