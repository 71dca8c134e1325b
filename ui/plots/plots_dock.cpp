#include "ui/plots/plots_dock.h"

#include <algorithm>
#include <utility>

#include <QCompleter>
#include <QEvent>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using series::Quantity;

namespace {
constexpr int kFollowMs = 250;
constexpr double kLiveSpan_s = 60;
}  // namespace

PlotsDock::PlotsDock(PlotFeed& feed, QWidget* parent)
    : QDockWidget(tr("Plots"), parent),
      feed_(feed),
      stack_(new QSplitter(Qt::Vertical, this)),
      path_(new QLineEdit(this)),
      paths_(new QStringListModel(this)),
      add_(new QPushButton(tr("Add"), this)),
      new_plot_(new QPushButton(tr("New plot"), this)),
      whole_(new QPushButton(tr("Whole bag"), this)),
      quantities_(new QToolButton(this)),
      said_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("plots"));
  auto* const body = new QWidget(this);
  said_->setSecondary(true);
  said_->setSample(QStringLiteral("x"));
  said_->setContentsMargins(8, 0, 8, 0);
  said_->hide();
  stack_->setChildrenCollapsible(false);
  stack_->setHandleWidth(1);
  body->setLayout(columnOf({buildControls(), said_, {stack_, 1}}, 0, QMargins()));
  setWidget(body);
  connect(&feed_, &PlotFeed::changed, this, &PlotsDock::refresh);
  connect(&follow_timer_, &QTimer::timeout, this, &PlotsDock::follow);
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    on_screen_ = visible;
    refresh();
    updateControls();
  });
  addPlot();
  sourceChanged();
}

// The feed may already be gone.
// Only ours: what Qt keeps of it for screen readers would outlive it.
PlotsDock::~PlotsDock() { disconnect(this, &QDockWidget::visibilityChanged, this, nullptr); }

QWidget* PlotsDock::buildControls() {
  auto* const box = new QWidget(this);
  auto* const rows = new QVBoxLayout(box);
  rows->setContentsMargins(8, 4, 8, 4);
  rows->setSpacing(4);
  auto* const typed = new QHBoxLayout;
  auto* const row = new QHBoxLayout;
  for (QHBoxLayout* const each : {typed, row}) {
    each->setSpacing(6);
    rows->addLayout(each);
  }
  path_->setPlaceholderText(tr("Field, for example /topic.member[0]"));
  path_->setAccessibleName(tr("Field to plot"));
  setLongest(*path_, int(series::FieldPath::kLongest));
  path_->setClearButtonEnabled(true);
  path_->installEventFilter(this);
  auto* const completer = new QCompleter(paths_, path_);
  completer->setFilterMode(Qt::MatchContains);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setMaxVisibleItems(12);
  path_->setCompleter(completer);
  add_->setToolTip(tr("Plot this field of the messages of a topic"));
  new_plot_->setToolTip(tr("Add another plot below"));
  whole_->setCheckable(true);
  whole_->setToolTip(tr("Read the whole bag, not only the part that is shown"));
  quantities_->setText(tr("Quantity"));
  quantities_->setToolTip(tr("Plot pose, speed and more"));
  quantities_->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(quantities_);
  menu->addAction(tr("Pose: x, y and heading"), this, [this] {
    for (const Quantity quantity : {Quantity::X, Quantity::Y, Quantity::Yaw}) addQuantity(quantity);
  });
  menu->addSeparator();
  for (const Quantity quantity : series::kQuantities)
    menu->addAction(plotName(quantity), this, [this, quantity] { addQuantity(quantity); });
  quantities_->setMenu(menu);
  for (QWidget* const button : std::initializer_list<QWidget*>{add_, new_plot_, whole_, quantities_})
    button->setObjectName(QStringLiteral("compact"));
  typed->addWidget(path_, 1);
  typed->addWidget(add_);
  row->addWidget(quantities_);
  row->addWidget(new_plot_);
  row->addStretch(1);
  row->addWidget(whole_);
  connect(path_, &QLineEdit::returnPressed, this, &PlotsDock::addTyped);
  connect(path_, &QLineEdit::textChanged, this, [this](const QString& text) {
    add_->setEnabled(!text.trimmed().isEmpty());
    say({});
  });
  connect(add_, &QPushButton::clicked, this, &PlotsDock::addTyped);
  connect(new_plot_, &QPushButton::clicked, this, [this] { at_hand_ = addPlot(); });
  connect(whole_, &QPushButton::toggled, this, &PlotsDock::wholeWanted);
  add_->setEnabled(false);
  return box;
}

bool PlotsDock::eventFilter(QObject* watched, QEvent* event) {
  // Completions depend on the messages in memory: updated when typing begins.
  if (watched == path_ && event->type() == QEvent::FocusIn) paths_->setStringList(feed_.fields());
  return QDockWidget::eventFilter(watched, event);
}

PlotWidget* PlotsDock::addPlot() {
  if (int(plots_.size()) >= kMostPlots) return nullptr;
  auto* const plot = new PlotWidget(stack_);
  plots_.push_back(plot);
  stack_->addWidget(plot);
  wire(plot);
  if (bag_) plot->setBounds(*bag_);
  plot->setSpan(span_);
  plot->setCurrent(current_s_);
  plot->setSince(seconds_ && bag_ ? std::optional(bag_->first) : std::nullopt);
  updateControls();
  refresh();
  return plot;
}

void PlotsDock::wire(PlotWidget* plot) {
  plot->installEventFilter(this);
  connect(plot, &PlotWidget::seekWanted, this, [this, plot](double at_s) {
    at_hand_ = plot;
    if (bag_) Q_EMIT seekWanted(std::clamp(at_s, bag_->first, bag_->second));
  });
  connect(plot, &PlotWidget::spanWanted, this, [this](double from_s, double until_s) {
    // For a live robot the present stays visible if it was.
    follows_ = feed_.now() <= until_s + (until_s - from_s) / 20;
    setSpan({from_s, until_s});
  });
  connect(plot, &PlotWidget::allWanted, this, &PlotsDock::showAll);
  connect(plot, &PlotWidget::pointed, this, [this](std::optional<double> at_s) {
    for (PlotWidget* const each : plots_) each->setPointed(at_s);
  });
  connect(plot, &PlotWidget::dropped, this, [this, plot](const PlotSelection& selection) {
    at_hand_ = plot;
    addCurve(plot, selection);
  });
  connect(plot, &PlotWidget::curveUnwanted, this, [this, plot](int curve) { removeCurve(plot, curve); });
  connect(plot, &PlotWidget::plotUnwanted, this, [this, plot] { removePlot(plot); });
  connect(plot, &PlotWidget::sinceWanted, this, [this](bool seconds) {
    seconds_ = seconds;
    const double since_s = bag_ ? bag_->first : feed_.now();
    for (PlotWidget* const each : plots_) each->setSince(seconds ? std::optional(since_s) : std::nullopt);
  });
}

PlotWidget* PlotsDock::atHand() const {
  for (PlotWidget* const plot : plots_) {
    if (plot->hasFocus()) return plot;
  }
  const bool there = std::find(plots_.begin(), plots_.end(), at_hand_) != plots_.end();
  return there ? at_hand_ : plots_.back();
}

void PlotsDock::removePlot(PlotWidget* plot) {
  setCurves(plot, {});
  if (plots_.size() > 1) {
    plots_.erase(std::find(plots_.begin(), plots_.end(), plot));
    plot->disconnect(this);
    plot->hide();
    plot->deleteLater();
  }
  updateControls();
}

void PlotsDock::removeFields(const std::set<std::string>& but_of) {
  QStringList removed;
  for (PlotWidget* const plot : std::vector(plots_)) {
    std::vector<PlotCurve> curves = plot->curves();
    const auto fields = std::stable_partition(curves.begin(), curves.end(), [&](const PlotCurve& curve) {
      const auto* const path = std::get_if<series::FieldPath>(&curve.selection);
      return !path || but_of.contains(path->topic);
    });
    if (fields == curves.end()) continue;
    for (auto field = fields; field != curves.end(); ++field)
      removed << plainWords(plotName(field->selection), 100);
    curves.erase(fields, curves.end());
    curves.empty() ? removePlot(plot) : setCurves(plot, std::move(curves));
  }
  if (!removed.isEmpty()) say(tr("No longer plotted: %1").arg(words::listed(removed)));
}

void PlotsDock::setCurves(PlotWidget* plot, std::vector<PlotCurve> curves) {
  for (const PlotCurve& before : plot->curves()) {
    const bool stays = std::any_of(curves.begin(), curves.end(),
                                   [&](const PlotCurve& each) { return each.selection == before.selection; });
    if (!stays) feed_.letGo(before.selection);
  }
  plot->setCurves(std::move(curves));
  refresh();
}

bool PlotsDock::addCurve(PlotWidget* plot, const PlotSelection& selection) {
  say({});
  std::vector<PlotCurve> curves = plot->curves();
  int all = 0;
  for (const PlotWidget* const each : plots_) all += int(each->curves().size());
  if (int(curves.size()) >= kPlotLooks || all >= kMostCurves) {
    say(tr("There are already as many curves as can be told apart. Remove one first: right-click the plot."));
    return false;
  }
  if (std::any_of(curves.begin(), curves.end(),
                  [&](const PlotCurve& each) { return each.selection == selection; })) {
    say(tr("%1 is already in this plot.").arg(plainWords(plotName(selection), 100)));
    return false;
  }
  // The first free look: removing a curve does not change the others.
  int look = 0;
  while (std::any_of(curves.begin(), curves.end(), [&](const PlotCurve& each) { return each.look == look; }))
    ++look;
  curves.push_back({selection, feed_.want(selection), look});
  setCurves(plot, std::move(curves));
  return true;
}

void PlotsDock::removeCurve(PlotWidget* plot, int curve) {
  std::vector<PlotCurve> curves = plot->curves();
  if (curve < 0 || curve >= int(curves.size())) return;
  curves.erase(curves.begin() + curve);
  setCurves(plot, std::move(curves));
}

void PlotsDock::addQuantity(Quantity quantity) {
  PlotWidget* plot = atHand();
  const auto fits = [&](const PlotWidget* each) {
    return each->curves().empty() || (plotUnit(each->curves().front().selection) == plotUnit(quantity) &&
                                      !plotUnit(quantity).isEmpty());
  };
  if (!fits(plot)) {
    const auto other = std::find_if(plots_.begin(), plots_.end(),
                                    [](const PlotWidget* each) { return each->curves().empty(); });
    PlotWidget* const fresh = other != plots_.end() ? *other : addPlot();
    if (fresh) plot = fresh;
  }
  at_hand_ = plot;
  addCurve(plot, quantity);
}

void PlotsDock::addTyped() {
  const QString text = path_->text().trimmed();
  if (text.isEmpty()) return;
  auto path = series::FieldPath::parse(text.toStdString());
  if (!path) {
    say(tr("\"%1\" is not a field. Enter a topic and a member of its messages, for example /topic.member[0].")
            .arg(plainWords(text, 100)));
    return;
  }
  if (!addCurve(atHand(), *path)) return;
  path_->clear();
  // It is only likely to be a typo if other numbers of the topic are known.
  if (feed_.lacks(*path))
    say(tr("No message so far has a number %1. It will be drawn as soon as one does.")
            .arg(plainWords(path->text(), 100)));
}

void PlotsDock::say(const QString& sentence) {
  said_->setText(sentence);
  said_->setVisible(!sentence.isEmpty());
}

QString PlotsDock::saidText() const { return said_->text(); }

void PlotsDock::openBag(double start_s, double end_s) {
  bag_ = {start_s, std::max(end_s, start_s + 1)};
  current_s_.reset();
  sourceChanged();
  showAll();
}

void PlotsDock::extendBag(double end_s) {
  if (!bag_ || end_s <= bag_->second) return;
  const bool all = span_ == *bag_;
  bag_->second = end_s;
  for (PlotWidget* const plot : plots_) plot->setBounds(*bag_);
  if (all) showAll();
}

void PlotsDock::closeBag() {
  bag_.reset();
  current_s_.reset();
  sourceChanged();
}

void PlotsDock::setCurrent(double at_s) {
  current_s_ = at_s;
  for (PlotWidget* const plot : plots_) plot->setCurrent(current_s_);
  // During playback the view follows the time.
  const double long_s = span_.second - span_.first;
  if (bag_ && span_ != *bag_ && on_screen_ && at_s > span_.second && at_s < span_.second + long_s / 4)
    setSpan({at_s - long_s / 10, at_s + long_s * 9 / 10});
}

void PlotsDock::sourceChanged() {
  follows_ = true;
  for (PlotWidget* const plot : plots_) {
    plot->setCurrent(current_s_);
    plot->setPresent(std::nullopt);
    plot->setSince(seconds_ && bag_ ? std::optional(bag_->first) : std::nullopt);
    if (bag_) plot->setBounds(*bag_);
  }
  if (!bag_) setSpan({feed_.now() - kLiveSpan_s, feed_.now()});
  updateControls();
  refresh();
}

void PlotsDock::showAll() {
  follows_ = true;
  if (bag_) return setSpan(*bag_);
  setSpan({feed_.now() - kLiveSpan_s, feed_.now()});
}

void PlotsDock::setSpan(PlotWidget::Range span) {
  span_ = span;
  for (PlotWidget* const plot : plots_) plot->setSpan(span);
}

void PlotsDock::follow() {
  if (bag_ || !feed_.live()) return;
  const double now_s = feed_.now();
  for (PlotWidget* const plot : plots_) {
    plot->setBounds({now_s - PlotFeed::kLive_s, now_s});
    plot->setPresent(now_s);
  }
  if (follows_) setSpan({now_s - (span_.second - span_.first), now_s});
}

void PlotsDock::refresh() {
  if (!on_screen_) return;
  for (PlotWidget* const plot : plots_) {
    QString hint;
    if (plot->curves().empty()) {
      hint = tr("Drop a number from a message here, type its name above, or choose a quantity.");
    } else if (bag_) {
      hint = tr("The part of the bag that has been read so far has no such data.");
    } else if (feed_.live()) {
      hint = tr("No data has arrived yet.");
    } else {
      hint = tr("Open a recording or connect to a robot to see curves.");
    }
    plot->setHint(hint);
    plot->refresh();
  }
}

void PlotsDock::updateControls() {
  whole_->setEnabled(bag_.has_value());
  new_plot_->setEnabled(int(plots_.size()) < kMostPlots);
  if (on_screen_ && !bag_ && feed_.live()) {
    if (!follow_timer_.isActive()) follow_timer_.start(kFollowMs);
  } else {
    follow_timer_.stop();
  }
}

QString PlotsDock::layout() const {
  QJsonArray all;
  for (const PlotWidget* const plot : plots_) {
    QJsonArray words;
    for (const PlotCurve& curve : plot->curves()) words << plotWord(curve.selection);
    all << words;
  }
  return QString::fromUtf8(QJsonDocument(all).toJson(QJsonDocument::Compact));
}

bool PlotsDock::restoreLayout(const QString& layout) {
  const QJsonDocument document = QJsonDocument::fromJson(layout.toUtf8());
  if (!document.isArray() || document.array().isEmpty()) return false;
  clearPlots();
  bool first = true;
  for (const QJsonValue& words : document.array()) {
    PlotWidget* const plot = std::exchange(first, false) ? plots_.front() : addPlot();
    if (!plot) break;
    for (const QJsonValue& word : words.toArray()) {
      if (const auto selection = plotFromWord(word.toString())) addCurve(plot, *selection);
    }
  }
  say({});
  return true;
}

void PlotsDock::clearPlots() {
  while (plots_.size() > 1) removePlot(plots_.back());
  removePlot(plots_.front());
}

}  // namespace mapwright::ui

#include "moc_plots_dock.cpp"
