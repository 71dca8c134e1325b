#include "ui/objects/object_card.h"

#include <utility>

#include <QGridLayout>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/objects/object_facts.h"
#include "ui/scene/map_scene.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

constexpr int kCardSymbolPx = 20, kIconPx = 16, kWidestValuePx = 260;
constexpr std::size_t kMostRows = 11;

QToolButton* cardButton(const QString& icon, const QString& text, const QString& tip, QWidget* parent) {
  QToolButton* const button = iconButton(icon, kIconPx, tip, parent);
  if (!text.isEmpty()) {
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

ObjectCard::ObjectCard(const scene::MapScene& scene, QWidget* parent)
    : QFrame(parent),
      scene_(scene),
      symbol_(new QLabel(this)),
      kind_(new PlainLabel(this)),
      name_(new PlainLabel(this)),
      grid_(new QGridLayout),
      buttons_(new QWidget(this)),
      copy_(cardButton(QStringLiteral("copy"), tr("Copy"), tr("Copy everything that is known about it"),
                       buttons_)),
      properties_(cardButton(QStringLiteral("list"), tr("Properties"),
                             tr("Show everything that is known about it in a panel"), buttons_)),
      next_(cardButton(QStringLiteral("layers"), {}, tr("Show what lies beneath (Alt+click)"), buttons_)),
      close_(cardButton(QStringLiteral("close"), {}, tr("Close (Esc)"), this)),
      more_(new PlainLabel(this)),
      hint_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("card"));
  setAccessibleName(tr("What is this?"));
  symbol_->setFixedSize(kCardSymbolPx, kCardSymbolPx);
  makeHeading(*kind_);
  more_->setSecondary(true);
  hint_->setSecondary(true);
  grid_->setHorizontalSpacing(12);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  buttons_->setLayout(rowOf({copy_, properties_, next_, LayoutItem::rest()}, 4, QMargins()));
  setLayout(columnOf({rowOf({symbol_, kind_, {name_, 1}, close_}, 8), grid_, more_, hint_, buttons_}, 6,
                     QMargins(10, 8, 10, 8)));
  connect(copy_, &QToolButton::clicked, this, &ObjectCard::copyWanted);
  connect(properties_, &QToolButton::clicked, this, &ObjectCard::propertiesWanted);
  connect(next_, &QToolButton::clicked, this, &ObjectCard::nextWanted);
  connect(close_, &QToolButton::clicked, this, &ObjectCard::closeWanted);
  setStaying(false);
  hide();
}

void ObjectCard::setStaying(bool stays) {
  stays_ = stays;
  setAttribute(Qt::WA_TransparentForMouseEvents, !stays);
  buttons_->setVisible(stays);
  close_->setVisible(stays);
}

void ObjectCard::show(const scene::MapObject& object, const std::vector<scene::ObjectProperty>& facts,
                      int beneath) {
  symbol_->setPixmap(QPixmap::fromImage(scene_.symbolOf(object, kCardSymbolPx, devicePixelRatioF())));
  kind_->setText(object.kind);
  name_->setText(object.name);
  const std::size_t rows = std::min(facts.size(), kMostRows);
  while (labels_.size() < 2 * rows) {
    auto* const name = new PlainLabel(this);
    auto* const value = new PlainLabel(this);
    name->setSecondary(true);
    value->setMaximumWidth(kWidestValuePx);
    const int row = int(labels_.size() / 2);
    grid_->addWidget(name, row, 0);
    grid_->addWidget(value, row, 1);
    labels_.insert(labels_.end(), {name, value});
  }
  for (std::size_t i = 0; i < rows; ++i) {
    labels_[2 * i]->setText(facts[i].name);
    labels_[2 * i + 1]->setText(facts[i].value);
  }
  known_ = int(facts.size());
  shown_.assign(facts.begin(), facts.begin() + std::ptrdiff_t(rows));
  next_->setVisible(beneath > 0);
  next_->setText(QString::number(beneath));
  next_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  hint_->setVisible(!stays_ && beneath > 0);
  hint_->setText(sentences::counted(tr("%1 other things here: Alt+click", nullptr, beneath), beneath));
  QFrame::show();
  rows_ = -1;
  showRows(int(rows));
  raise();
}

void ObjectCard::showRows(int rows) {
  if (std::exchange(rows_, rows) == rows) return;
  for (std::size_t i = 0; i < labels_.size(); ++i) labels_[i]->setVisible(int(i / 2) < rows);
  more_->setVisible(rows < known_);
  more_->setText(tr("%1 more in the properties").arg(known_ - rows));
  // Rows have come and gone: their room is reckoned anew at once, not with the next event.
  for (PlainLabel* const label : labels_) label->updateGeometry();
  layout()->invalidate();
  layout()->activate();
  resize(layout()->totalSizeHint());
}

QString ObjectCard::title() const {
  return name_->text().isEmpty() ? kind_->text() : QStringLiteral("%1 %2").arg(kind_->text(), name_->text());
}

QString ObjectCard::moreShown() const { return more_->isHidden() ? QString() : more_->text(); }

QStringList ObjectCard::lines() const {
  QStringList lines;
  for (const scene::ObjectProperty& fact : shown_) lines << words::about(fact.name, fact.value);
  return lines;
}

}  // namespace mapwright::ui

#include "moc_object_card.cpp"
