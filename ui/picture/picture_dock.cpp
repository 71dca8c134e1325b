#include "ui/picture/picture_dock.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"
#include "ui/picture/picture_text.h"

namespace mapwright::window {

namespace {

QLabel* pictureText(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

QLabel* pictureHeading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

QPushButton* pictureButton(const QString& text, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QStringLiteral("compact"));
  return button;
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

void colour(QLabel* label, const QColor& color) {
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, color);
  label->setPalette(palette);
}

}  // namespace

PictureDock::PictureDock(PictureEditing* editing, PictureTool* tool, QWidget* parent)
    : QDockWidget(tr("Edit map"), parent),
      editing_(editing),
      tool_(tool),
      empty_(pictureText(this)),
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
  buildEnd(column);
  empty_->setContentsMargins(8, 4, 8, 4);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* all = new QWidget(this);
  auto* rows = new QVBoxLayout(all);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(empty_);
  rows->addWidget(body_, 1);
  all->setMinimumWidth(220);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(all);
  setWidget(scroll);
  connect(editing_, &PictureEditing::stateChanged, this, &PictureDock::refresh);
  connect(tool_, &PictureTool::modeChanged, this, &PictureDock::refresh);
  refresh();
}

void PictureDock::buildOffer(QVBoxLayout* column) {
  offer_box_ = new QWidget(body_);
  auto* rows = new QVBoxLayout(offer_box_);
  rows->setContentsMargins(0, 0, 0, 6);
  offer_ = pictureText(offer_box_);
  restore_ = pictureButton(tr("Restore"), offer_box_);
  auto* drop = pictureButton(tr("Discard draft"), offer_box_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(restore_);
  buttons->addWidget(drop);
  buttons->addStretch();
  rows->addWidget(offer_);
  rows->addLayout(buttons);
  connect(restore_, &QPushButton::clicked, this, &PictureDock::draftWanted);
  connect(drop, &QPushButton::clicked, this, &PictureDock::draftNotWanted);
  offer_box_->hide();
  column->addWidget(offer_box_);
}

void PictureDock::setOffer(const QString& sentence) {
  offer_->setText(sentence);
  colour(offer_, appColors().warning_text);
  offer_box_->setVisible(!sentence.isEmpty());
}

void PictureDock::buildModes(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  auto* group = new QButtonGroup(this);
  for (int i = 0; i < kPaintModes; ++i) {
    const PaintMode mode = PaintMode(i);
    auto* button = new QToolButton(body_);
    button->setIcon(themedIcon(modeIcon(mode)));
    button->setIconSize({20, 20});
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setToolTip(modeTip(mode));
    button->setAccessibleName(modeName(mode));
    group->addButton(button);
    row->addWidget(button);
    modes_[std::size_t(i)] = button;
    connect(button, &QToolButton::clicked, this, [this, mode] { Q_EMIT modeWanted(mode); });
  }
  row->addStretch();
  column->addLayout(row);
}

void PictureDock::buildKinds(QVBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  auto* group = new QButtonGroup(this);
  for (int i = 0; i < picture::kKinds; ++i) {
    const picture::Kind kind = picture::Kind(i);
    auto* button = new QToolButton(body_);
    button->setText(kindName(kind));
    button->setCheckable(true);
    group->addButton(button);
    row->addWidget(button, 1);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    kinds_[std::size_t(i)] = button;
    connect(button, &QToolButton::clicked, this, [this, kind] { editing_->setKind(kind); });
  }
  size_ = new QSpinBox(body_);
  size_->setRange(1, picture::kWidestBrush);
  size_->setSuffix(tr(" cells"));
  size_->setAccessibleName(tr("Size of the brush"));
  size_->setToolTip(tr("Width of brush, eraser and line (on the map: comma and full stop)"));
  size_m_ = new QLabel(body_);
  connect(size_, &QSpinBox::valueChanged, editing_, &PictureEditing::setAcross);
  auto* sizes = new QHBoxLayout;
  sizes->setSpacing(8);
  sizes->addWidget(size_);
  sizes->addWidget(size_m_, 1);
  grid->addWidget(new QLabel(tr("Paint"), body_), 0, 0);
  grid->addLayout(row, 0, 1);
  grid->addWidget(new QLabel(tr("Size"), body_), 1, 0);
  grid->addLayout(sizes, 1, 1);
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
}

void PictureDock::buildTidying(QVBoxLayout* column) {
  column->addSpacing(6);
  column->addWidget(pictureHeading(tr("Clean up"), body_));
  tidy_where_ = pictureText(body_);
  column->addWidget(tidy_where_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  const std::array<int, 3> most{picture::kLargestSpeck, picture::kWidestGap, picture::kWidestGap};
  const std::array<int, 3> usual{4, 3, 3};
  for (int i = 0; i < 3; ++i) {
    const Tidying what = Tidying(i);
    auto* spin = new QSpinBox(body_);
    spin->setRange(1, most[std::size_t(i)]);
    spin->setValue(usual[std::size_t(i)]);
    spin->setSuffix(tr(" cells"));
    spin->setToolTip(tidyTip(what));
    auto* label = new QLabel(tidyName(what), body_);
    label->setToolTip(tidyTip(what));
    label->setBuddy(spin);
    spin->setAccessibleName(tidyName(what));
    auto* look = pictureButton(tr("Look"), body_);
    look->setToolTip(tr("Preview the result without changing anything"));
    look->setAccessibleName(tr("Preview: %1").arg(tidyName(what)));
    connect(look, &QPushButton::clicked, this,
            [this, what, spin] { Q_EMIT lookWanted(what, spin->value()); });
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
  found_ = pictureText(preview_row_);
  apply_ = pictureButton(tr("Apply"), preview_row_);
  drop_ = pictureButton(tr("Cancel"), preview_row_);
  row->addWidget(found_, 1);
  row->addWidget(apply_);
  row->addWidget(drop_);
  connect(apply_, &QPushButton::clicked, editing_, &PictureEditing::applyPreview);
  connect(drop_, &QPushButton::clicked, editing_, [this] {
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
  auto* rows = new QVBoxLayout(decision_);
  rows->setContentsMargins(0, 6, 0, 0);
  conflict_ = pictureText(decision_);
  mine_ = pictureButton(tr("Keep mine"), decision_);
  theirs_ = pictureButton(tr("Take theirs"), decision_);
  auto* show = pictureButton(tr("Show"), decision_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(mine_);
  buttons->addWidget(theirs_);
  buttons->addStretch();
  buttons->addWidget(show);
  rows->addWidget(conflict_);
  rows->addLayout(buttons);
  connect(mine_, &QPushButton::clicked, this, [this] { editing_->decide(false); });
  connect(theirs_, &QPushButton::clicked, this, [this] { editing_->decide(true); });
  connect(show, &QPushButton::clicked, this, &PictureDock::locateConflictWanted);
  column->addWidget(decision_);
}

void PictureDock::buildEnd(QVBoxLayout* column) {
  status_ = pictureText(body_);
  compare_ = pictureButton(tr("Before…"), body_);
  compare_->setToolTip(tr("Compare the saved map with the current one, with a divider that can be dragged"));
  discard_ = pictureButton(tr("Discard"), body_);
  discard_->setToolTip(tr("Restore the saved map; can be undone"));
  save_ = pictureButton(tr("Save"), body_);
  save_->setIcon(themedIcon(QStringLiteral("save")));
  stop_ = pictureButton(tr("Stop"), body_);
  stop_->setToolTip(tr("Stop sending; the robot keeps its current picture"));
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  row->addWidget(compare_);
  row->addStretch();
  row->addWidget(discard_);
  row->addWidget(stop_);
  row->addWidget(save_);
  column->addWidget(status_);
  column->addLayout(row);
  connect(compare_, &QPushButton::clicked, this, &PictureDock::compareWanted);
  connect(discard_, &QPushButton::clicked, this, &PictureDock::discardWanted);
  connect(save_, &QPushButton::clicked, this, &PictureDock::saveWanted);
  connect(stop_, &QPushButton::clicked, this, &PictureDock::stopSavingWanted);
  setLocal(true);
}

void PictureDock::setWhyNot(const QString& sentence) {
  why_not_ = sentence;
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
  save_->setToolTip(
      local ? tr("Save the picture of the map (Ctrl+S). Its map.yaml is not changed")
            : tr("Send the picture to the robot (Ctrl+S). Its position, size and resolution stay the same"));
}

QString PictureDock::savingText() const {
  if (!travelled_) return tr("Saving…");
  if (*travelled_ < 100) return tr("Sending: %1 %").arg(*travelled_);
  return tr("Sent. Waiting for the robot to show it…");
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
  const bool open = editing_->isOpen() && why_not_.isEmpty();
  empty_->setVisible(!open);
  empty_->setText(why_not_);
  body_->setVisible(open);
  if (!open) return;
  modes_[std::size_t(tool_->mode())]->setChecked(true);
  for (int i = 0; i < picture::kKinds; ++i) {
    const picture::Kind kind = picture::Kind(i);
    QToolButton* const button = kinds_[std::size_t(i)];
    button->setEnabled(editing_->holds(kind));
    button->setToolTip(editing_->holds(kind)
                           ? kindTip(kind)
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
  colour(tidy_where_, appColors().secondary_text);
  const bool reckoning = editing_->reckoning();
  const bool previewing = editing_->preview().has_value() || editing_->looking() || reckoning;
  for (QPushButton* button : tidy_buttons_) button->setEnabled(!saving_);
  preview_row_->setVisible(previewing);
  found_->setText(reckoning             ? tr("Computing…")
                  : editing_->preview() ? previewText(*editing_->preview())
                                        : tr("Preparing the preview…"));
  for (int i = 0; i < picture::kKinds; ++i) {
    const auto& preview = editing_->preview();
    const std::int64_t cells = preview ? preview->changes.become[std::size_t(i)] : 0;
    legend_[std::size_t(i)].text->setText(becomesText(picture::Kind(i), cells));
    legend_[std::size_t(i)].row->setVisible(cells > 0);
  }
  apply_->setVisible(!reckoning);
  apply_->setEnabled(editing_->preview() && !editing_->preview()->step.patch.empty());
  decision_->setVisible(editing_->conflicts() > 0);
  conflict_->setText(conflictText(editing_->conflicts()));
  colour(conflict_, appColors().warning_text);
  status_->setText(!trouble_.isEmpty() ? trouble_
                   : saving_           ? savingText()
                                       : changedText(editing_->changedCells()));
  colour(status_, trouble_.isEmpty() ? appColors().secondary_text : appColors().error_text);
  const bool unsaved = editing_->unsaved();
  compare_->setEnabled(unsaved);
  discard_->setEnabled(unsaved && !saving_);
  save_->setVisible(!saving_ || !travelled_);
  stop_->setVisible(saving_ && travelled_);
  stop_->setEnabled(travelled_ && *travelled_ < 100);
  save_->setEnabled(unsaved && !saving_ && editing_->conflicts() == 0);
}

}  // namespace mapwright::window

#include "moc_picture_dock.cpp"
