#include "ui/maps/expected_controller.h"

#include <algorithm>

#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>

#include "compare/comparison_sentence.h"
#include "compare/difference_picture.h"
#include "compare/picture_reading.h"
#include "compare/picture_view.h"
#include "render/tile_colors.h"
#include "sentences/fault_sentence.h"
#include "sentences/language.h"
#include "session/session.h"
#include "suite/facts.h"
#include "suite/judgement.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/maps/picture_swipe.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"
#include "ui/shell/current_session.h"
#include "ui/shot/layer_subscription.h"
#include "ui/shot/map_shot.h"
#include "ui/shot/picture.h"
#include "ui/shot/view_facts.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

constexpr auto kExpectedFolderKey = "expectedPictures/folder";
constexpr std::int64_t kMostDrawnPixels = 30'000'000;  // Qt reads pictures up to 128 MiB
constexpr QSize kLargestShown(1'000, 700);
constexpr int kMostListPx = 120;
constexpr double kMostOfScreen = 0.9;
constexpr int kExpectedTries = 3, kExpectedLookEveryMs = 20;
constexpr double kExpectedWithinS = 10, kExpectedTopicsWithinS = 3;

/// What changed, and where: all of it.
QStringList changesOf(const suite::ViewOutcome& outcome) {
  QStringList changes;
  for (const suite::ViewOutcome::ClusterRow& row : outcome.clusters) {
    if (!row.near.isEmpty()) changes << words::about(row.place, row.near);
  }
  for (const auto& [where, said] :
       {std::pair(ExpectedController::tr("Everywhere: %1"), &outcome.everywhere),
        std::pair(ExpectedController::tr("There or elsewhere: %1"), &outcome.somewhere),
        std::pair(ExpectedController::tr("Elsewhere: %1"), &outcome.elsewhere)}) {
    for (const QString& change : *said) changes << where.arg(change);
  }
  return changes;
}

/// Numbers stay beside their percent sign.
QString onOneLine(QString sentence) {
  return sentence.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"));
}

QScrollArea* scrolled(const QImage& difference) {
  auto* const picture = new QLabel;
  picture->setPixmap(QPixmap::fromImage(difference));
  picture->setAccessibleName(ExpectedController::tr("What differs"));
  auto* const area = new QScrollArea;
  area->setWidget(picture);
  area->setAccessibleName(ExpectedController::tr("What differs"));
  return area;
}

}  // namespace

/// The map drawn once more, aside.
struct ExpectedController::Comparing {
  Comparing(QString picture, session::Session& drawn)
      : expected(std::move(picture)), session(drawn), topics(drawn) {
    shot.enter(shot::Stage::Settling, 0);
    since.start();
  }
  double seconds() const { return double(since.elapsed()) / 1000; }
  /// As the facts say that the picture was drawn; without facts as on screen.
  void choose(const scene::MapScene& on_screen, const geometry::ViewTransform& view, bool is_raw) {
    raw = is_raw;
    const auto facts = suite::factsIn(suite::factsBeside(expected));
    const bool known = facts && !facts->theme.empty();
    look.view = view;
    look.dark = known ? facts->theme == "dark" : on_screen.theme().dark;
    look.colors = known ? render::ColorMode::Normal : on_screen.colorMode();
    look.slices_marked = false;
    for (const scene::Layer layer : scene::allLayers()) {
      const bool named = known && std::find(facts->layers.begin(), facts->layers.end(),
                                            scene::layerName(layer).toStdString()) != facts->layers.end();
      if (known ? named : on_screen.layerVisible(layer)) look.layers.insert(layer);
    }
  }
  void await() {
    using shot::Awaited;
    const auto draws = [this](scene::Layer layer) { return look.layers.contains(layer); };
    topics.ask(look.layers, false);
    if (draws(scene::Layer::Submaps))
      shot.await(Awaited::Submaps, [this] { return session.settled(kExpectedTries); });
    if (draws(scene::Layer::WholeMap))
      shot.await(Awaited::WholeMap, [this, with_points = draws(scene::Layer::Waypoints)] {
        const session::MapSlot& slot = session.wholeMap();
        return slot.settled() && !(with_points && slot.waypointsAwaited());
      });
    if (draws(scene::Layer::Closures) && session.poseGraph().offered()) {
      session.poseGraph().want();
      shot.await(Awaited::PoseGraph, [this] { return !session.poseGraph().loading(); });
    }
    shot.await(Awaited::Topics,
               [this] { return topics.in() || shot.sinceConnected(seconds()) > kExpectedTopicsWithinS; });
  }

  QString expected;
  session::Session& session;
  shot::Look look;
  shot::MapShot shot{{.timeout_s = kExpectedWithinS}};
  shot::EndOfWaiting end = shot::EndOfWaiting::None;
  shot::LayerSubscription topics;
  bool raw = false;  // cells alone
  std::unique_ptr<shot::Picture> picture;
  QElapsedTimer since;
  QTimer poll;
};

struct ExpectedController::Compared {
  QString problem;  // not empty: nothing was compared
  QString sentence;
  QStringList changes;
  QImage expected, actual, difference;  // difference: null where nothing differs
};

ExpectedController::ExpectedController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), share_(context.workers) {
  context_.actions.add({.id = "compareExpected",
                        .text = tr("Compare &with expected…"),
                        .tip = tr("Compare the map with an expected picture of the same place"),
                        .needs_session = true,
                        .menu = {MenuGroup::Exports, 20}},
                       this, &ExpectedController::askAndCompare);
}

ExpectedController::~ExpectedController() = default;

void ExpectedController::setSession(session::Session*) { comparing_.reset(); }

void ExpectedController::report(const QString& problem) {
  context_.overlay.toasts()->add(Mark::Bad, problem);
}

void ExpectedController::askAndCompare() {
  const QString path = QFileDialog::getOpenFileName(&context_.window, tr("Compare with an expected picture"),
                                                    context_.settings.value(kExpectedFolderKey).toString(),
                                                    tr("PNG pictures (*.png)"));
  if (path.isEmpty()) return;
  context_.settings.setValue(kExpectedFolderKey, QFileInfo(path).absolutePath());
  compareWith(path);
}

void ExpectedController::compareWith(const QString& picture) {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const QString name = QFileInfo(picture).fileName();
  const auto read = compare::PictureReading::open(picture.toStdString());
  if (!read) return report(sentences::sentenceOf(read.error()));
  const auto view = compare::viewBeside(picture, read->size());
  if (!view)
    return report(
        tr("No report beside %1 says which part of the map it shows. snapshot --report and suite accept "
           "write one.")
            .arg(name));
  if (read->size().pixels() > kMostDrawnPixels)
    return report(tr("%1 is too large to be compared here. The command suite has no such limit.").arg(name));
  comparing_ = std::make_unique<Comparing>(picture, *session);
  comparing_->choose(context_.scene, *view, read->isRaw());
  comparing_->await();
  connect(&comparing_->poll, &QTimer::timeout, this, &ExpectedController::look);
  comparing_->poll.start(kExpectedLookEveryMs);
}

void ExpectedController::look() {
  using shot::EndOfWaiting;
  Comparing& now = *comparing_;
  const bool online = now.session.connection().phase == robot::ConnectionPhase::Online;
  EndOfWaiting end = now.shot.end(now.seconds(), true, {});
  if (end == EndOfWaiting::None && !online) end = EndOfWaiting::LinkLost;  // nothing more will come
  if (end == EndOfWaiting::None) return;
  now.end = end;
  now.shot.addIf(end == EndOfWaiting::TimeUp || end == EndOfWaiting::LinkLost, shot::Lack::NotSettled);
  now.shot.enter(shot::Stage::Drawing, now.seconds());
  now.poll.stop();
  if (now.raw) {
    const bool whole = now.look.layers.contains(scene::Layer::WholeMap);
    now.picture = shot::makeRawPicture(shot::rawContent(now.session, now.look.view, whole), context_.workers);
  } else {
    now.picture = std::make_unique<shot::ScenePicture>(now.look, now.session, context_.workers);
  }
  // Queued: the picture is deleted there.
  connect(now.picture.get(), &shot::Picture::finished, this, &ExpectedController::onPicture,
          Qt::QueuedConnection);
  // As the expected one: commands draw in English, whatever the window speaks.
  const sentences::InEnglish labels;
  now.picture->start();
}

void ExpectedController::onPicture() {
  if (!comparing_) return;
  comparing_->topics.ask({}, false);
  const std::unique_ptr<Comparing> done = std::move(comparing_);
  // Of the same moment as the picture: the session goes on.
  const suite::Facts facts = shot::factsOf(done->look, done->session);
  const auto folder = std::make_shared<QTemporaryDir>();
  if (!folder->isValid()) return report(tr("There is not enough room to draw the map again."));
  const QString actual = folder->filePath(QStringLiteral("actual.png"));
  const auto fault = [&] {
    const sentences::InEnglish labels;
    return done->picture->write(actual);
  }();
  if (fault) return report(sentences::sentenceOf(*fault));
  QString lacks;
  const auto silent = silentOnline(done->session);
  if (!done->shot.complete())
    lacks = (done->end == shot::EndOfWaiting::LinkLost
                 ? tr("The robot is not connected, so not everything has arrived.")
             : silent ? tr("Nothing has come from the robot since %1, so not everything has arrived.")
                            .arg(QLocale::c().toString(*silent, QStringLiteral("HH:mm:ss")))
                      : tr("Not everything had arrived within %1 s.").arg(QString::number(kExpectedWithinS)));
  share_.startLong([this, folder, expected = done->expected, actual, facts, lacks] {
    Compared compared = compare(expected, actual, facts);
    compared.sentence = words::paragraph({compared.sentence, lacks});
    QMetaObject::invokeMethod(
        this, [this, compared] { compared.problem.isEmpty() ? show(compared) : report(compared.problem); },
        Qt::QueuedConnection);
  });
}

/// On any thread.
ExpectedController::Compared ExpectedController::compare(const QString& expected, const QString& actual,
                                                         const suite::Facts& facts) {
  Compared compared;
  const suite::Judgement judgement = suite::judge({expected}, actual, {});
  if (judgement.unreadable()) {
    compared.problem = judgement.sentence;
    return compared;
  }
  suite::ViewOutcome outcome;
  outcome.sentence = compare::comparisonText(*judgement.comparison, facts.view);
  compared.expected = QImage(expected);
  compared.actual = QImage(actual);
  const bool differs = judgement.verdict == suite::Verdict::Differs;
  if (differs) suite::explain(judgement, facts, outcome);
  compared.sentence = outcome.sentence;
  if (!differs) return compared;
  compared.changes = changesOf(outcome);
  const QString difference = QFileInfo(actual).dir().filePath(QStringLiteral("difference.png"));
  if (const auto fault = compare::writeDifference(*judgement.comparison, expected.toStdString(),
                                                  actual.toStdString(), difference.toStdString())) {
    compared.problem = sentences::sentenceOf(*fault);
    return compared;
  }
  compared.difference = QImage(difference);
  if (compared.difference.width() > kLargestShown.width() ||
      compared.difference.height() > kLargestShown.height())
    compared.difference =
        compared.difference.scaled(kLargestShown, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  return compared;
}

void ExpectedController::show(const Compared& compared) {
  delete dialog_;
  dialog_ = new QDialog(&context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  dialog_->setWindowTitle(tr("Compared with the expected picture"));
  auto* const swipe =
      new PictureSwipe(compared.expected, compared.actual, tr("Expected"), tr("Now"), dialog_);
  connect(&swipe->handle(), &SwipeHandle::escaped, dialog_, &QDialog::reject);
  QWidget* pictures = swipe;
  if (!compared.difference.isNull()) {
    auto* const tabs = new QTabWidget(dialog_);
    tabs->addTab(swipe, tr("Expected and now"));
    tabs->addTab(scrolled(compared.difference), tr("Difference"));
    pictures = tabs;
  }
  auto* const list = new QListWidget(dialog_);
  list->setAccessibleName(tr("What changed"));
  list->setWordWrap(true);
  list->addItems(compared.changes);
  int rows_px = 2 * list->frameWidth();
  for (int row = 0; row < list->count(); ++row) rows_px += list->sizeHintForRow(row);
  list->setFixedHeight(std::min(rows_px, kMostListPx));
  list->setVisible(!compared.changes.isEmpty());
  auto* const close = new QPushButton(tr("Close"), dialog_);
  giveRoles(*close, {});
  connect(close, &QPushButton::clicked, dialog_, &QDialog::reject);
  dialog_->setLayout(columnOf({textLabel(onOneLine(compared.sentence), dialog_),
                               {pictures, 1},
                               list,
                               rowOf({LayoutItem::rest(), close})}));
  dialog_->resize(dialog_->sizeHint().boundedTo(context_.window.screen()->availableSize() * kMostOfScreen));
  swipe->handle().setFocus();
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_expected_controller.cpp"
