// The facts that made a picture.
#pragma once

#include "session/session.h"
#include "suite/facts.h"
#include "ui/shot/picture.h"

namespace mapwright::ui::shot {

/// Of what `look` shows of `session` at present.
suite::Facts factsOf(const Look& look, const session::Session& session);

}  // namespace mapwright::ui::shot
