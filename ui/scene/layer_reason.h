// Why a robot, or a file, has nothing for a layer.
#pragma once

#include <QString>

#include "ui/scene/layer.h"

namespace mapwright::ui::scene {

/// A sentence; empty: it may have something.
QString whyEmpty(Layer layer, robot::Robot& robot);

}  // namespace mapwright::ui::scene
