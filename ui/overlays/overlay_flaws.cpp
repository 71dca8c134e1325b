#include "ui/overlays/overlay_flaws.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "placing/warnings.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/state_mark.h"

namespace mapwright::ui {

using overlays::Rule;

namespace {

constexpr std::size_t kMostFlaws = 1'000;  // in the list
const QString kOffKey = QStringLiteral("overlays/rulesOff"), kRadiusKey = QStringLiteral("overlays/radius");

QString ruleText(Rule rule) {
  switch (rule) {
    case Rule::DuplicateId:
      return OverlayFlaws::tr("Ids that occur twice");
    case Rule::DuplicateName:
      return OverlayFlaws::tr("Names that occur twice");
    case Rule::SelfIntersection:
      return OverlayFlaws::tr("Outlines that cross themselves");
    case Rule::ZeroArea:
      return OverlayFlaws::tr("Outlines without an area");
    case Rule::TooFewPoints:
      return OverlayFlaws::tr("Too few points");
    case Rule::OutsideMap:
      return OverlayFlaws::tr("Outside the map");
    case Rule::InWall:
      return OverlayFlaws::tr("Points in a wall");
    case Rule::ChargerWithoutDock:
      return OverlayFlaws::tr("Chargers without a docking point");
    case Rule::DoorWithoutMac:
      return OverlayFlaws::tr("Doors without a MAC address");
    case Rule::BadNumber:
      return OverlayFlaws::tr("Unusable numbers");
    case Rule::Unreachable:
      return OverlayFlaws::tr("Points that the robot cannot reach");
    case Rule::Unreadable:
      break;
  }
  return OverlayFlaws::tr("What cannot be read");
}

}  // namespace

OverlayFlaws::OverlayFlaws(QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget(this)),
      rules_(new QToolButton(this)),
      menu_(new QMenu(this)),
      radius_(numberField(
          this,
          {.least = 0, .most = placing::kMostRadiusM, .decimals = 2, .name = tr("Radius of the robot")})),
      more_(wrappedLabel({}, this)),
      not_checked_(wrappedLabel({}, this)) {
  list_->setAccessibleName(tr("What is wrong with the overlays"));
  list_->setWordWrap(true);
  list_->setToolTip(tr("Click one to see it on the map"));
  rules_->setText(tr("Rules"));
  rules_->setToolTip(tr("What is looked for"));
  rules_->setPopupMode(QToolButton::InstantPopup);
  rules_->setMenu(menu_);
  radius_->setToolTip(tr("Radius of the robot: 0 is that of its own footprint"));
  setToldRadius(placing::kUsualRadiusM);
  fillMenu();
  // Above the list: below it, it is out of sight in a low window.
  setLayout(columnOf({rowOf({rules_, LayoutItem::rest(), radius_}, 4, QMargins(6, 4, 6, 4)),
                      not_checked_,
                      {list_, 1},
                      more_},
                     0, QMargins()));
  for (QLabel* label : {more_, not_checked_}) label->setContentsMargins(8, 2, 8, 2);
  more_->hide();
  const auto choose = [this](const QListWidgetItem* item) {
    Q_EMIT chosen(flaws_[std::size_t(list_->row(item))]);
  };
  connect(list_, &QListWidget::itemClicked, this, choose);
  connect(list_, &QListWidget::itemActivated, this, choose);
  connect(radius_, &QDoubleSpinBox::valueChanged, this, &OverlayFlaws::optionsChanged);
}

void OverlayFlaws::fillMenu() {
  menu_->clear();
  for (int i = 0; i <= int(overlays::kLastRule); ++i) {
    const auto rule = Rule(i);
    QAction* const action = menu_->addAction(ruleText(rule));
    action->setCheckable(true);
    action->setChecked(!off_.contains(rule));
    connect(action, &QAction::toggled, this, [this, rule](bool on) {
      on ? void(off_.erase(rule)) : void(off_.insert(rule));
      Q_EMIT optionsChanged();
    });
  }
}

void OverlayFlaws::setFlaws(std::vector<ShownFlaw> flaws) {
  const int at = list_->currentRow();
  const auto same = [&](std::size_t i) {
    return i < flaws_.size() && i < flaws.size() && flaws_[i].key == flaws[i].key &&
           flaws_[i].rule == flaws[i].rule;
  };
  const bool stays = at >= 0 && same(std::size_t(at));
  flaws_ = std::move(flaws);
  list_->clear();
  const QPixmap mark = markPixmap(Mark::Warning);
  for (std::size_t i = 0; i < std::min(flaws_.size(), kMostFlaws); ++i)
    list_->addItem(new QListWidgetItem(mark, flaws_[i].sentence));
  if (stays) list_->setCurrentRow(at);
  const auto more = qsizetype(flaws_.size() - std::min(flaws_.size(), kMostFlaws));
  more_->setVisible(more > 0);
  more_->setText(sentences::counted(tr("%1 more are not listed.", nullptr, sentences::formOf(more)), more));
}

std::optional<double> OverlayFlaws::radius() const {
  return radius_->value() > 0 ? std::optional(radius_->value()) : std::nullopt;
}

void OverlayFlaws::setToldRadius(double told_m) {
  radius_->setSpecialValueText(tr("Robot: %1 m").arg(QString::number(told_m, 'f', 2)));
}

void OverlayFlaws::setNotChecked(const QString& sentence) {
  not_checked_->setText(sentence);
  not_checked_->setVisible(!sentence.isEmpty());
}

void OverlayFlaws::recall(const QSettings& settings) {
  off_.clear();
  for (const QString& name : settings.value(kOffKey).toStringList()) {
    if (const auto rule = overlays::ruleCalled(name.toStdString())) off_.insert(*rule);
  }
  fillMenu();
  const QSignalBlocker quiet(radius_);
  radius_->setValue(settings.value(kRadiusKey, 0.0).toDouble());
}

void OverlayFlaws::remember(QSettings& settings) const {
  QStringList names;
  for (const Rule rule : off_) {
    const std::string_view name = overlays::nameOf(rule);
    names << QString::fromLatin1(name.data(), qsizetype(name.size()));
  }
  settings.setValue(kOffKey, names);
  settings.setValue(kRadiusKey, radius_->value());
}

}  // namespace mapwright::ui

#include "moc_overlay_flaws.cpp"
