#include "ui/view/compare_bar.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

#include "render/grid_palettes.h"
#include "render/sample_grid.h"
#include "robot/sends_map.h"
#include "sentences/problem_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/view/on_screen.h"

namespace mapwright::ui {

namespace {

using scene::CompareMode;

/// What a colour of the difference means against a second map, and against an earlier state of the same one.
QString meaningOf(render::Difference what, bool earlier) {
  switch (what) {
    case render::Difference::Appeared:
      return earlier ? CompareBar::tr("new since then") : CompareBar::tr("new in the second");
    case render::Difference::Vanished:
      return earlier ? CompareBar::tr("gone since then") : CompareBar::tr("gone in the second");
    case render::Difference::OnlyFirst:
      return earlier ? CompareBar::tr("known then only") : CompareBar::tr("known in the first only");
    default:
      return earlier ? CompareBar::tr("known now only") : CompareBar::tr("known in the second only");
  }
}

/// A swatch in the colour of the difference, with its label.
class LegendEntry : public QWidget {
 public:
  LegendEntry(render::Difference what, QWidget* parent) : QWidget(parent), what_(what) { setEarlier(false); }
  void setEarlier(bool earlier) {
    text_ = meaningOf(what_, earlier);
    setFixedSize(fontMetrics().horizontalAdvance(text_) + 24, 20);
    setAccessibleName(text_);
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const UiColors colors = appColors();
    QPainter painter(this);
    painter.setPen(colors.neutral);
    painter.setBrush(QColor(render::differencePalette(colors.dark)[std::size_t(what_)]));
    painter.drawRect(QRectF(0.5, 4.5, 12, 11));
    painter.setPen(colors.text);
    painter.drawText(rect().adjusted(18, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text_);
  }

 private:
  render::Difference what_;
  QString text_;
};

}  // namespace

CompareBar::CompareBar(QWidget* parent)
    : QFrame(parent),
      first_(new PlainLabel(this)),
      status_(new PlainLabel(this)),
      second_(new QComboBox(this)),
      swipe_(new QToolButton(this)),
      difference_(new QToolButton(this)),
      close_(iconButton(QStringLiteral("close"), 16, tr("Stop comparing (Esc)"), this, tr("Stop comparing"))),
      legend_(new QWidget(this)) {
  setObjectName(QStringLiteral("compareBar"));
  setAutoFillBackground(true);
  first_->setSample(QStringLiteral("Ground floor, east"));
  first_->setElideMode(Qt::ElideRight);
  second_->setObjectName(QStringLiteral("second"));
  second_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  second_->setMinimumContentsLength(16);
  second_->setMaxVisibleItems(16);
  second_->setAccessibleName(tr("Second map"));
  second_->setToolTip(tr("The map to compare the open one with"));
  auto* modes = new QButtonGroup(this);
  for (QToolButton* button : {swipe_, difference_}) {
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    modes->addButton(button);
  }
  swipe_->setText(tr("Swipe"));
  swipe_->setToolTip(tr("One map to the left of a divider, the other to the right; drag it"));
  difference_->setText(tr("Difference"));
  status_->setSecondary(true);
  status_->setSample(tr("Fetching the map"));
  status_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

  auto* legend_row = new QHBoxLayout(legend_);
  legend_row->setContentsMargins(0, 0, 0, 0);
  legend_row->setSpacing(12);
  for (const auto what : {render::Difference::Appeared, render::Difference::Vanished,
                          render::Difference::OnlyFirst, render::Difference::OnlySecond})
    legend_row->addWidget(new LegendEntry(what, legend_));
  legend_row->addStretch();

  auto* line =
      rowOf({{first_, 1}, new PlainLabel(tr("with"), this), {second_, 2}, swipe_, difference_, close_}, 8);
  setLayout(columnOf({line, rowOf({legend_, {status_, 1}}, 12)}, 2, QMargins(12, 4, 8, 4)));
  hide();

  connect(swipe_, &QToolButton::clicked, this, [this] { Q_EMIT modeWanted(CompareMode::Swipe); });
  connect(difference_, &QToolButton::clicked, this, [this] { Q_EMIT modeWanted(CompareMode::Difference); });
  connect(close_, &QToolButton::clicked, this, &CompareBar::closed);
  connect(second_, &QComboBox::activated, this, [this](int row) {
    if (row >= 0 && row < int(offers_.size())) Q_EMIT secondWanted(offers_[std::size_t(row)]);
  });
}

void CompareBar::fill(session::Session* session, const std::optional<SecondMap>& chosen) {
  std::vector<SecondMap> offers;
  QStringList titles;
  const auto offer = [&](auto&& what, const QString& title) {
    offers.emplace_back(std::forward<decltype(what)>(what));
    titles << title;
  };
  if (session->robot().submapSource()) offer(SubmapsAside{}, tr("the submaps (they are on the left)"));
  if (robot::sendsItsMap(session->robot())) offer(map::MapKey{map::MapKind::Live, {}}, tr("Live map"));
  for (const map::CatalogueEntry& entry : session->catalogue().entries()) {
    QString title = QStringLiteral("%1  (%2)")
                        .arg(plainWords(mapTitle(entry.name), 60), plainWords(map::toText(entry.key), 30));
    if (entry.is_current) title += tr("  current");
    offer(entry.key, title);
  }
  const bool kept = chosen && std::holds_alternative<KeptState>(*chosen);
  if (session->wholeMap().source() || kept)
    offer(KeptState{}, kept ? tr("The state before") : tr("Keep the current state"));
  const bool file = chosen && std::holds_alternative<FileAside>(*chosen);
  offer(FileAside{}, file ? comparedNames(*session).right : tr("File…"));
  if (offers != offers_ || titles != titles_) {
    const QSignalBlocker quiet(second_);
    offers_ = offers;
    titles_ = titles;
    second_->clear();
    second_->addItems(titles);
  }
  int row = -1;
  for (std::size_t i = 0; chosen && i < offers_.size(); ++i) {
    if (offers_[i] == *chosen) row = int(i);
  }
  second_->setCurrentIndex(row);
  second_->setPlaceholderText(tr("Choose a map"));
}

void CompareBar::sync(session::Session* session, CompareMode mode, const std::optional<SecondMap>& chosen) {
  setVisible(session && mode != CompareMode::Off);
  if (isHidden()) return;
  fill(session, chosen);
  const session::MapSlot& first = session->wholeMap();
  const session::MapSlot& second = session->comparedMap();
  const bool submaps = chosen && std::holds_alternative<SubmapsAside>(*chosen);
  first_->setText(comparedNames(*session).left);
  swipe_->setChecked(mode == CompareMode::Swipe);
  difference_->setChecked(mode == CompareMode::Difference);
  difference_->setEnabled(!submaps);
  difference_->setToolTip(submaps ? tr("A difference needs two whole maps")
                                  : tr("Show the differences in colour"));
  legend_->setVisible(mode == CompareMode::Difference);
  for (QObject* const child : legend_->children()) {
    if (auto* const entry = dynamic_cast<LegendEntry*>(child)) entry->setEarlier(second.showsEarlierState());
  }
  QString status;
  if (second.phase() == session::MapSlot::Phase::Failed) {
    status = sentences::sentenceOf(second.remark());
  } else if (!second.settled()) {
    status = mapProgressText(second);
  } else if (!chosen) {
    status = tr("Choose a map to compare the open one with.");
  } else if (first.phase() == session::MapSlot::Phase::Failed) {
    status = sentences::sentenceOf(first.remark());
  } else if (!first.settled()) {
    status = mapProgressText(first);
  }
  status_->setText(status);
  status_->setVisible(!status.isEmpty());
}

QString CompareBar::firstShown() const { return first_->text(); }
QString CompareBar::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }

void CompareBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    Q_EMIT closed();
    return;
  }
  QFrame::keyPressEvent(event);
}

}  // namespace mapwright::ui

#include "moc_compare_bar.cpp"
