#include "ui/overlays/overlay_arranging.h"

#include <QMenu>

#include "overlays/overlay_edits.h"
#include "overlays/overlay_shapes.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/overlays/overlay_text.h"

namespace mapwright::ui {

using geometry::WorldRect;
using overlays::Alignment;
using overlays::Spread;

OverlayArranging::OverlayArranging(WindowContext& context, edit::OverlayEditing* editing, QObject* parent)
    : QObject(parent), editing_(editing), menu_(new QMenu(tr("&Arrange"), &context.window)) {
  const QString edit = menuName(Menu::Edit);
  const auto add = [&](const char* id, const QString& text, const QString& tip, std::size_t least,
                       std::function<Shifts(const std::vector<WorldRect>&)> how) {
    QAction* const action =
        context.actions.add(edit, QLatin1String(id), text, {}, {}, Reach::Everywhere, tip);
    connect(action, &QAction::triggered, this, [this, least, how = std::move(how)] {
      arrange(least > 2 ? tr("distribute %1") : tr("align %1"), how);
    });
    actions_.emplace_back(action, least);
    menu_->addAction(action);
  };
  struct Line {
    const char* id;
    QString text, tip;
    Alignment how;
  };
  for (const Line& line : {Line{"alignOverlaysLeft", tr("Align &left edges of overlays"),
                                tr("Along the x axis, to the smallest x of the selection"), Alignment::Left},
                           Line{"alignOverlaysCentre", tr("Align &centres of overlays in x"),
                                tr("One above the other"), Alignment::CentreX},
                           Line{"alignOverlaysRight", tr("Align &right edges of overlays"),
                                tr("To the largest x of the selection"), Alignment::Right},
                           Line{"alignOverlaysTop", tr("Align &top edges of overlays"),
                                tr("To the largest y of the selection"), Alignment::Top},
                           Line{"alignOverlaysMiddle", tr("Align centres of overlays in &y"),
                                tr("One beside the other"), Alignment::CentreY},
                           Line{"alignOverlaysBottom", tr("Align &bottom edges of overlays"),
                                tr("To the smallest y of the selection"), Alignment::Bottom}})
    add(line.id, line.text, line.tip, 2, [how = line.how](const std::vector<WorldRect>& boxes) {
      return overlays::shiftsToAlign(boxes, how);
    });
  menu_->addSeparator();
  add("spreadOverlaysX", tr("Equal &gaps of overlays in x"), tr("The outermost two stay"), 3,
      [](const std::vector<WorldRect>& boxes) { return overlays::shiftsToSpread(boxes, Spread::X); });
  add("spreadOverlaysY", tr("Equal gaps of overlays in y"), tr("The outermost two stay"), 3,
      [](const std::vector<WorldRect>& boxes) { return overlays::shiftsToSpread(boxes, Spread::Y); });
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged})
    connect(editing_, signal, this, &OverlayArranging::refresh);
  connect(editing_, &edit::OverlayEditing::selectionChanged, this, &OverlayArranging::refresh);
  refresh();
}

void OverlayArranging::arrange(const QString& text,
                               const std::function<Shifts(const std::vector<WorldRect>&)>& how) {
  if (!editing_->editable()) return;
  std::vector<FeatureKey> keys;
  std::vector<WorldRect> boxes;
  for (const FeatureKey key : editing_->selected()) {
    WorldRect box;
    for (const overlays::Path& path : overlays::shapesOf(*editing_->document().find(key)).paths) {
      for (const Eigen::Vector2d& point : path.points) box.extend(point);
    }
    if (box.empty()) continue;  // it has no place
    keys.push_back(key);
    boxes.push_back(box);
  }
  const Shifts shifts = how(boxes);
  std::map<FeatureKey, Feature> moved;
  for (std::size_t i = 0; i < keys.size(); ++i)
    moved.emplace(keys[i], overlays::movedBy(*editing_->document().find(keys[i]), shifts[i]));
  editing_->put({}, moved, editing_->saying(text));
}

void OverlayArranging::refresh() {
  const std::size_t count = editing_->selected().size();
  for (const auto& [action, least] : actions_) {
    allow(action, editing_->editable() && count >= least,
          least == 2 ? tr("Select two overlays at least.") : tr("Select three overlays at least."));
  }
}

}  // namespace mapwright::ui

#include "moc_overlay_arranging.cpp"
