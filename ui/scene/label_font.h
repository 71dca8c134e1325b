// The font of labels, which the program brings along.
#pragma once

namespace mapwright::ui::scene {

inline constexpr char kLabelFontFile[] = ":/fonts/DejaVuSans.ttf";  // a resource of app

}  // namespace mapwright::ui::scene
