#include "ui/picture/picture_dock.h"

#include <QApplication>
#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {

QLabel* heading(const QString& text, QWidget* parent) {
  auto* const label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// The mark of cells of this kind on the map.
QPixmap signOf(picture::Kind kind, double ratio) {
  constexpr int kEdgePx = 14;
  QPixmap sign(QSize(kEdgePx, kEdgePx) * ratio);
  sign.setDevicePixelRatio(ratio);
  const BecomesLook look = becomesLook(kind);
  sign.fill(look.color);
  QPainter painter(&sign);
  painter.fillRect(QRect(0, 0, kEdgePx, kEdgePx), QBrush(QColor(0, 0, 0, 150), look.lines));
  return sign;
}

/// A part of the dock that is shown at times.
QVBoxLayout* partOf(QWidget* part, QVBoxLayout* column, const QMargins& margins) {
  auto* const rows = new QVBoxLayout(part);
  rows->setContentsMargins(margins);
  column->addWidget(part);
  return rows;
}

}  // namespace

PictureDock::PictureDock(edit::PictureEditing* editing, PictureTool* tool, QWidget* parent)
    : QDockWidget(tr("Edit map"), parent),
      editing_(editing),
      tool_(tool),
      empty_(wrappedLabel({}, this)),
      body_(new QWidget(this)) {
  setObjectName(QStringLiteral("picture"));
  auto* column = new QVBoxLayout(body_);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  buildOffer(column);
  buildModes(column);
  buildKinds(column);
  buildTidying(column);
  buildDecision(column);
  column->addStretch();
  empty_->setContentsMargins(8, 4, 8, 4);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* all = new QWidget(this);
  all->setLayout(columnOf({empty_, {body_, 1}}, -1, QMargins()));
  all->setMinimumWidth(220);
  buildEnd();
  setScrolledWidget(*this, all, end_);
  connect(editing_, &edit::PictureEditing::stateChanged, this, &PictureDock::refresh);
  connect(tool_, &PictureTool::modeChanged, this, &PictureDock::refresh);
  refresh();
}

void PictureDock::buildOffer(QVBoxLayout* column) {
  offer_box_ = new QWidget(body_);
  offer_ = wrappedLabel({}, offer_box_);
  auto* const restore = compactButton(tr("Restore"), offer_box_);
  auto* const drop = compactButton(tr("Discard draft"), offer_box_);
  QVBoxLayout* const rows = partOf(offer_box_, column, {0, 0, 0, 6});
  rows->addWidget(offer_);
  rows->addLayout(rowOf({restore, drop, LayoutItem::rest()}));
  connect(restore, &QPushButton::clicked, this, &PictureDock::draftWanted);
  connect(drop, &QPushButton::clicked, this, &PictureDock::draftNotWanted);
  offer_box_->hide();
}

void PictureDock::setOffer(const QString& sentence) {
  offer_->setText(sentence);
  setTextColor(*offer_, appColors().warning_text);
  showPart(*offer_box_, !sentence.isEmpty());
}

void PictureDock::showPart(QWidget& part, bool visible) {
  const bool left = !visible && part.isAncestorOf(QApplication::focusWidget());
  part.setVisible(visible);
  if (left) Q_EMIT mapWanted();
}

void PictureDock::buildModes(QVBoxLayout* column) {
  struct Texts {
    QString name, tip, icon;
  };
  const std::array<Texts, kPaintModes> texts{{
      {tr("Brush"), tr("Brush: paint freehand"), QStringLiteral("brush")},
      {tr("Eraser"), tr("Eraser: restore the saved map where you paint"), QStringLiteral("eraser")},
      {tr("Line"), tr("Line: a straight wall, as wide as the brush"), QStringLiteral("line")},
      {tr("Rectangle"), tr("Rectangle: filled"), QStringLiteral("rectangle")},
      {tr("Polygon"), tr("Polygon: filled, corner by corner"), QStringLiteral("polygon")},
      {tr("Fill"), tr("Fill: a connected area of the same kind"), QStringLiteral("fill")},
      {tr("Select"), tr("Select: a part to copy, move, paint or clean up"), QStringLiteral("select")},
  }};
  auto* row = rowOf({}, 2);
  auto* group = new QButtonGroup(this);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto* button = new QToolButton(body_);
    button->setIcon(themedIcon(texts[i].icon));
    button->setIconSize({20, 20});
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setToolTip(texts[i].tip);
    button->setAccessibleName(texts[i].name);
    group->addButton(button);
    row->addWidget(button);
    modes_[i] = button;
    connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT modeWanted(PaintMode(i)); });
  }
  row->addStretch();
  column->addLayout(row);
}

void PictureDock::buildKinds(QVBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  auto* row = rowOf({}, 2);
  auto* group = new QButtonGroup(this);
  const std::array<QString, picture::kKinds> names{tr("Free"), tr("Occupied"), tr("Unknown")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto* button = new QToolButton(body_);
    button->setText(names[i]);
    button->setCheckable(true);
    group->addButton(button);
    row->addWidget(button, 1);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    kinds_[i] = button;
    connect(button, &QToolButton::clicked, this, [this, i] { editing_->setKind(picture::Kind(i)); });
  }
  size_ = new WholeBox(body_);
  size_->setRange(1, picture::kWidestBrush);
  size_->setSuffix(tr(" cells"));
  size_->setAccessibleName(tr("Size of the brush"));
  size_->setToolTip(tr("Width of brush, eraser and line (on the map: comma and full stop)"));
  size_m_ = new QLabel(body_);
  connect(size_, &QSpinBox::valueChanged, editing_, &edit::PictureEditing::setAcross);
  grid->addWidget(new QLabel(tr("Paint"), body_), 0, 0);
  grid->addLayout(row, 0, 1);
  grid->addWidget(new QLabel(tr("Size"), body_), 1, 0);
  grid->addLayout(rowOf({size_, {size_m_, 1}}, 8), 1, 1);
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
}

void PictureDock::buildTidying(QVBoxLayout* column) {
  column->addSpacing(6);
  column->addWidget(heading(tr("Clean up"), body_));
  tidy_where_ = wrappedLabel({}, body_);
  column->addWidget(tidy_where_);
  struct Texts {
    QString name, tip;
    int most, usual;
  };
  const std::array<Texts, 3> texts{{
      {tr("Specks up to"),
       tr("Removes groups of at most this many occupied cells: they become like their surroundings"),
       picture::kLargestSpeck, 4},
      {tr("Gaps in walls up to"), tr("Closes gaps of at most this many cells between occupied cells"),
       picture::kWidestGap, 3},
      {tr("Ragged edges up to"),
       tr("Smooths spikes and notches of at most this width between free and unknown areas"),
       picture::kWidestGap, 3},
  }};
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  for (int i = 0; i < int(texts.size()); ++i) {
    const auto& [name, tip, most, usual] = texts[std::size_t(i)];
    auto* spin = new WholeBox(body_);
    spin->setRange(1, most);
    spin->setValue(usual);
    spin->setSuffix(tr(" cells"));
    spin->setToolTip(tip);
    spin->setAccessibleName(name);
    auto* label = new QLabel(name, body_);
    label->setToolTip(tip);
    label->setBuddy(spin);
    auto* look = compactButton(tr("Preview"), body_, tr("Show the result without changing anything"));
    look->setAccessibleName(tr("Preview: %1").arg(name));
    connect(look, &QPushButton::clicked, this,
            [this, i, spin] { Q_EMIT lookWanted(edit::Tidying(i), spin->value()); });
    grid->addWidget(label, i, 0);
    grid->addWidget(spin, i, 1);
    grid->addWidget(look, i, 2);
    tidy_sizes_[std::size_t(i)] = spin;
    tidy_buttons_[std::size_t(i)] = look;
  }
  grid->setColumnStretch(0, 1);
  column->addLayout(grid);
  preview_row_ = new QWidget(body_);
  auto* row = new QHBoxLayout(preview_row_);
  row->setContentsMargins(0, 0, 0, 0);
  found_ = wrappedLabel({}, preview_row_);
  apply_ = compactButton(tr("Apply"), preview_row_);
  auto* const drop = compactButton(tr("Cancel"), preview_row_);
  row->addWidget(found_, 1);
  row->addWidget(apply_);
  row->addWidget(drop);
  connect(apply_, &QPushButton::clicked, editing_, &edit::PictureEditing::applyPreview);
  connect(drop, &QPushButton::clicked, editing_, [this] {
    editing_->stop();
    editing_->dropPreview();
  });
  column->addWidget(preview_row_);
  for (int i = 0; i < picture::kKinds; ++i) {
    LegendRow& legend = legend_[std::size_t(i)];
    legend.row = new QWidget(body_);
    auto* parts = new QHBoxLayout(legend.row);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->setSpacing(6);
    auto* sign = new QLabel(legend.row);
    sign->setPixmap(signOf(picture::Kind(i), devicePixelRatioF()));
    legend.text = new QLabel(legend.row);
    parts->addWidget(sign);
    parts->addWidget(legend.text, 1);
    column->addWidget(legend.row);
  }
}

void PictureDock::buildDecision(QVBoxLayout* column) {
  decision_ = new QWidget(body_);
  conflict_ = wrappedLabel({}, decision_);
  mine_ = compactButton(tr("Keep mine"), decision_);
  theirs_ = compactButton(tr("Take theirs"), decision_);
  auto* show = compactButton(tr("Show"), decision_);
  QVBoxLayout* const rows = partOf(decision_, column, {0, 6, 0, 0});
  rows->addWidget(conflict_);
  rows->addLayout(rowOf({mine_, theirs_, LayoutItem::rest(), show}));
  connect(mine_, &QPushButton::clicked, this, [this] { editing_->decide(false); });
  connect(theirs_, &QPushButton::clicked, this, [this] { editing_->decide(true); });
  connect(show, &QPushButton::clicked, this, &PictureDock::locateConflictWanted);
}

void PictureDock::buildEnd() {
  status_ = wrappedLabel({}, this);
  compare_ =
      compactButton(tr("Before…"), this,
                    tr("Compare the saved map with the current one, with a divider that can be dragged"));
  copies_ = compactButton(tr("Copies…"), this,
                          tr("What the robot had before it was overwritten; it can be put back"));
  discard_ = compactButton(tr("Discard"), this, tr("Restore the saved map; can be undone"));
  save_ = compactButton(tr("Save"), this);
  save_->setIcon(themedIcon(QStringLiteral("save")));
  stop_ = compactButton(tr("Stop"), this, tr("Stop sending; the robot keeps its current picture"));
  connect(compare_, &QPushButton::clicked, this, &PictureDock::compareWanted);
  connect(copies_, &QPushButton::clicked, this, &PictureDock::copiesWanted);
  connect(discard_, &QPushButton::clicked, this, &PictureDock::discardWanted);
  connect(save_, &QPushButton::clicked, this, &PictureDock::saveWanted);
  connect(stop_, &QPushButton::clicked, this, &PictureDock::stopSavingWanted);
  setLocal(true);
  end_ = new QWidget(this);
  end_->setLayout(
      columnOf({status_, rowOf({compare_, copies_, LayoutItem::rest(), discard_, stop_, save_}, 6)}, 6,
               QMargins(8, 4, 8, 8)));
}

void PictureDock::setUnavailableReason(const QString& sentence) {
  unavailable_reason_ = sentence;
  refresh();
}

void PictureDock::setSaving(bool saving, const QString& trouble) {
  saving_ = saving;
  trouble_ = trouble;
  refresh();
}

void PictureDock::setTravelled(std::optional<double> part) {
  const auto percent = part ? std::optional(int(*part * 100)) : std::nullopt;
  if (percent == travelled_) return;
  travelled_ = percent;
  refresh();
}

void PictureDock::setLocal(bool local) {
  copies_->setVisible(!local);
  save_->setToolTip(
      local ? tr("Save the picture of the map (Ctrl+S). Its map.yaml is not changed")
            : tr("Send the picture to the robot (Ctrl+S). Its position, size and resolution stay the same"));
}

/// The keys of the tool work here, too: they are what the texts name.
void PictureDock::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  for (int i = 0; enter && i < int(tidy_sizes_.size()); ++i) {
    // Another number is looked at before it is applied.
    QSpinBox* const size = tidy_sizes_[std::size_t(i)];
    if (size->hasFocus()) return Q_EMIT lookWanted(edit::Tidying(i), size->value());
  }
  const bool any_preview = editing_->preview() || editing_->looking() || editing_->reckoning();
  const bool of_tool = (any_preview && (enter || key == Qt::Key_Escape)) || key == Qt::Key_Comma ||
                       key == Qt::Key_Period || key == Qt::Key_Delete;
  const bool taken =
      of_tool && editing_->isOpen() && tool_->keyPressed({key, event->modifiers(), event->isAutoRepeat()});
  taken ? event->accept() : QDockWidget::keyPressEvent(event);
}

QString PictureDock::statusText() const {
  if (!trouble_.isEmpty()) return trouble_;
  if (saving_ && !travelled_) return tr("Saving…");
  if (saving_ && *travelled_ < 100) return tr("Sending: %1 %").arg(*travelled_);
  if (saving_) return tr("Sent. Waiting for the robot to show it…");
  const std::int64_t cells = editing_->changedCells();
  return cells == 0 ? tr("No unsaved changes.") : tr("Changed: %1.").arg(edit::cellsText(cells));
}

/// "Removes 12 specks (48 cells)."
QString PictureDock::previewText() const {
  if (editing_->reckoning()) return tr("Computing…");
  if (!editing_->preview()) return tr("Preparing the preview…");
  const edit::TidyPreview& preview = *editing_->preview();
  if (preview.step.patch.empty()) return tr("There is nothing to clean up.");
  const QString cells = edit::cellsText(preview.found.cells);
  const QString specks = sentences::counted(tr("%1 specks", nullptr, sentences::formOf(preview.found.pieces)),
                                            preview.found.pieces);
  return words::paragraph({preview.what == edit::Tidying::Specks ? tr("Removes %1 (%2).").arg(specks, cells)
                                                                 : tr("Changes %1.").arg(cells),
                           preview.changes.all ? QString() : tr("Not all of it is marked on the map.")});
}

QStringList PictureDock::legend() const {
  QStringList words;
  for (const LegendRow& legend : legend_) {
    if (!legend.row->isHidden()) words << legend.text->text();
  }
  return words;
}

QString PictureDock::status() const { return status_->text(); }

void PictureDock::refresh() {
  const bool open = editing_->isOpen() && unavailable_reason_.isEmpty();
  empty_->setVisible(!open);
  empty_->setText(unavailable_reason_);
  body_->setVisible(open);
  end_->setVisible(open);
  if (!open) return;
  modes_[std::size_t(tool_->mode())]->setChecked(true);
  const std::array<QString, picture::kKinds> tips{tr("Free: where robots may drive"),
                                                  tr("Occupied: walls and other obstacles"),
                                                  tr("Unknown: not observed yet")};
  for (int i = 0; i < picture::kKinds; ++i) {
    const picture::Kind kind = picture::Kind(i);
    QToolButton* const button = kinds_[std::size_t(i)];
    button->setEnabled(editing_->holds(kind));
    button->setToolTip(editing_->holds(kind)
                           ? tips[std::size_t(i)]
                           : tr("According to its map.yaml, no gray level of this picture means unknown."));
    if (kind == editing_->kind()) button->setChecked(true);
  }
  {
    const QSignalBlocker quiet(size_);
    size_->setValue(editing_->across());
  }
  size_m_->setText(
      tr("%1 m").arg(QLocale::c().toString(editing_->across() * editing_->reference().resolution_m, 'g', 3)));
  tidy_where_->setText(editing_->selection().empty()
                           ? tr("Applies to the whole map. To clean up only a part, select it.")
                           : tr("Applies to the selection."));
  setTextColor(*tidy_where_, appColors().secondary_text);
  const bool reckoning = editing_->reckoning();
  const bool previewing = editing_->preview().has_value() || editing_->looking() || reckoning;
  for (QPushButton* button : tidy_buttons_) button->setEnabled(!saving_);
  showPart(*preview_row_, previewing);
  found_->setText(previewText());
  const std::array<QString, picture::kKinds> becomes{tr("becomes free: %1"), tr("becomes occupied: %1"),
                                                     tr("becomes unknown: %1")};
  for (int i = 0; i < picture::kKinds; ++i) {
    const auto& preview = editing_->preview();
    const std::int64_t cells = preview ? preview->changes.become[std::size_t(i)] : 0;
    legend_[std::size_t(i)].text->setText(becomes[std::size_t(i)].arg(edit::cellsText(cells)));
    legend_[std::size_t(i)].row->setVisible(cells > 0);
  }
  apply_->setVisible(!reckoning);
  apply_->setEnabled(editing_->preview() && !editing_->preview()->step.patch.empty());
  showPart(*decision_, editing_->conflicts() > 0);
  conflict_->setText(tr("Changed differently here and elsewhere: %1. Which version do you want to keep?")
                         .arg(edit::cellsText(editing_->conflicts())));
  setTextColor(*conflict_, appColors().warning_text);
  status_->setText(statusText());
  setTextColor(*status_, trouble_.isEmpty() ? appColors().secondary_text : appColors().error_text);
  const bool unsaved = editing_->unsaved();
  compare_->setEnabled(unsaved);
  discard_->setEnabled(unsaved && !saving_);
  save_->setVisible(!saving_ || !travelled_);
  stop_->setVisible(saving_ && travelled_);
  stop_->setEnabled(travelled_ && *travelled_ < 100);
  save_->setEnabled(unsaved && !saving_ && editing_->conflicts() == 0);
}

}  // namespace mapwright::ui

#include "moc_picture_dock.cpp"
