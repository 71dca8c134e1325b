#include "ui/slam/leave_out_controller.h"

#include <algorithm>
#include <utility>

#include <QButtonGroup>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QStandardPaths>

#include "jobs/leave_out.h"
#include "robot/slam_file.h"
#include "sentences/plural.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/slam/closures_model.h"

namespace mapwright::ui {
namespace {

const QString kSuffix = QStringLiteral(".pbstream");
const QString kFolderKey = QStringLiteral("leaveOut/folder");

template <class Id>
QString named(Id id) {
  return QString::fromStdString(map::toText(id));
}

LeaveOutChoice closureChoice(map::SubmapId submap, map::NodeId node) {
  return {LeaveOutDialog::tr("The loop closure of submap %1 and node %2").arg(named(submap), named(node)),
          LeaveOutDialog::tr("Only this constraint goes."),
          QStringLiteral("closure-%1-%2").arg(named(submap), named(node)),
          {{}, {}, {{submap, node}}}};
}

LeaveOutChoice submapsChoice(const std::vector<map::SubmapId>& ids) {
  const auto count = int(ids.size());
  LeaveOutChoice choice{
      count == 1 ? LeaveOutDialog::tr("Submap %1").arg(named(ids.front())) : submapsText(count),
      LeaveOutDialog::tr("All constraints of what goes are left out, too. The scans stay."),
      count == 1 ? QStringLiteral("submap-%1").arg(named(ids.front()))
                 : QStringLiteral("%1-submaps").arg(count),
      {}};
  choice.parts.submaps.insert(ids.begin(), ids.end());
  return choice;
}

LeaveOutChoice trajectoryChoice(std::int32_t trajectory) {
  return {
      LeaveOutDialog::tr("Trajectory %1").arg(trajectory),
      LeaveOutDialog::tr("All of it goes: submaps, scans, sensor data, and the constraints from and to it."),
      QStringLiteral("trajectory-%1").arg(trajectory),
      {{trajectory}, {}, {}}};
}

}  // namespace

LeaveOutDialog::LeaveOutDialog(const QString& from, std::vector<LeaveOutChoice> choices,
                               const QString& folder, const std::shared_ptr<work::Workers>& workers,
                               QWidget* parent)
    : QDialog(parent),
      from_(from),
      folder_(folder),
      choices_(std::move(choices)),
      form_(new QWidget(this)),
      group_(new QButtonGroup(this)),
      note_(wrappedLabel({}, this)),
      said_(textLabel({}, this)),
      path_(new QLineEdit(this)),
      progress_(new QProgressBar(this)),
      write_(new QPushButton(tr("Write the new file"), this)),
      open_(new QPushButton(tr("Open the new file"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      run_(workers) {
  setWindowTitle(tr("Leave out"));
  setMinimumWidth(520);
  setTextColor(*note_, appColors().secondary_text);
  note_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  note_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  said_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  said_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  makeLine(*progress_);
  progress_->setAccessibleName(tr("Progress"));
  auto* const browse = new QPushButton(tr("&Browse…"), this);
  giveRoles(*open_, {cancel_});
  giveRoles(*write_, {browse, cancel_});
  open_->hide();
  auto* const path_label = new QLabel(tr("New &file"), this);
  path_label->setBuddy(path_);
  auto* const heading =
      wrappedLabel(tr("A new file is written, without what is chosen here. %1 stays as it is.")
                       .arg(plainWords(QFileInfo(from_).fileName(), 80)),
                   this);
  QVBoxLayout* const radios = columnOf({}, 6);
  for (const LeaveOutChoice& choice : choices_) {
    auto* const button = new QRadioButton(choice.text, this);
    group_->addButton(button, int(group_->buttons().size()));
    radios->addWidget(button);
  }
  group_->buttons().front()->setChecked(true);
  form_->setLayout(
      columnOf({heading, radios, note_, rowOf({path_label, {path_, 1}, browse}, 8)}, 10, QMargins()));
  setLayout(columnOf({form_, said_, progress_, rowOf({LayoutItem::rest(), cancel_, open_, write_}, 8)}, 10,
                     QMargins(16, 16, 16, 16)));
  connect(group_, &QButtonGroup::idToggled, this, &LeaveOutDialog::sync);
  connect(path_, &QLineEdit::textEdited, this, [this](const QString& text) {
    say({}, false);
    write_->setEnabled(!text.trimmed().isEmpty());
  });
  connect(browse, &QPushButton::clicked, this, &LeaveOutDialog::browse);
  connect(write_, &QPushButton::clicked, this, &LeaveOutDialog::start);
  connect(cancel_, &QPushButton::clicked, this, &LeaveOutDialog::reject);
  connect(open_, &QPushButton::clicked, this, [this] {
    accept();
    Q_EMIT openWanted(written_);
  });
  sync();
  path_->setFocus();
}

QString LeaveOutDialog::noteText() const { return note_->text(); }
QString LeaveOutDialog::saidText() const { return said_->text(); }

void LeaveOutDialog::sync() {
  const LeaveOutChoice& choice = choices_[std::size_t(group_->checkedId())];
  note_->setText(
      tr("%1 No pose changes: Cartographer optimises them when it loads the new file and runs again.")
          .arg(choice.note));
  say({}, false);
  if (path_->text() != proposed_) return;  // the user has chosen
  const QString name = QStringLiteral("%1-without-%2").arg(QFileInfo(from_).completeBaseName(), choice.file);
  proposed_ = QDir(folder_).filePath(name + kSuffix);
  for (int number = 2; QFileInfo::exists(proposed_); ++number)
    proposed_ = QDir(folder_).filePath(QStringLiteral("%1-%2%3").arg(name).arg(number).arg(kSuffix));
  path_->setText(proposed_);
}

void LeaveOutDialog::browse() {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Write the new file to"), path_->text(), tr("Cartographer state files (*.pbstream)"), nullptr,
      QFileDialog::DontConfirmOverwrite);  // nothing is written over
  if (path.isEmpty()) return;
  path_->setText(path);
  say({}, false);
  write_->setEnabled(true);
}

void LeaveOutDialog::start() {
  if (run_.running()) return;
  QString path = QFileInfo(path_->text().trimmed()).absoluteFilePath();
  if (!path.endsWith(kSuffix, Qt::CaseInsensitive)) path += kSuffix;
  path_->setText(path);
  setRunning(true);
  say(tr("Reading the file…"), false);
  const auto progressed = [this](double done) {
    progress_->setValue(int(done * progress_->maximum()));
    say(done < 0.25  ? tr("Reading the file…")
        : done < 0.5 ? tr("Writing the new file…")
                     : tr("Reading the new file again and comparing it…"),
        false);
  };
  const auto job = [this, from = from_, what = choices_[std::size_t(group_->checkedId())].parts,
                    path](const BackgroundRun::Running& run) -> BackgroundRun::Then {
    const auto said = jobs::leaveOutSaying(
        from, what, path, [&] { return run.cancelled.load(); }, run.proceed);
    if (said) return [this, path, said = *said] { onWritten(path, said); };
    return
        [this, why = run.cancelled ? tr("Cancelled. Nothing was written.") : said.error()] { onFailed(why); };
  };
  run_.start(job, progressed);
}

void LeaveOutDialog::setRunning(bool running) {
  form_->setEnabled(!running);
  write_->setEnabled(!running);
  cancel_->setEnabled(true);
  progress_->setValue(0);
  progress_->setVisible(running);
}

void LeaveOutDialog::say(const QString& text, bool wrong) {
  setTextColor(*said_, wrong ? appColors().error_text : appColors().secondary_text);
  said_->setText(text);
  // Otherwise what is above would be squeezed.
  if (const int needed = layout()->totalHeightForWidth(width()); needed > height()) resize(width(), needed);
}

void LeaveOutDialog::onFailed(const QString& why) {
  setRunning(false);
  path_->setFocus();  // it was lost while the form was disabled
  say(why, true);
}

void LeaveOutDialog::onWritten(const QString& path, const QStringList& said) {
  setRunning(false);
  written_ = path;
  form_->hide();
  setTextColor(*said_, appColors().text);
  said_->setText(said.join(QStringLiteral("\n\n")));
  write_->hide();
  open_->show();
  open_->setDefault(true);
  open_->setFocus();
  cancel_->setText(tr("Close"));
  adjustSize();
  Q_EMIT written(written_);
}

void LeaveOutDialog::reject() {
  if (!run_.running()) return QDialog::reject();
  run_.cancel();
  cancel_->setEnabled(false);
}

LeaveOutController::LeaveOutController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  context_.actions.addToMapMenu({MapMenuGroup::Submap, 20},
                                [this](QMenu& menu, const Eigen::Vector2d& world) {
                                  const auto id = context_.scene.submapAt(world);
                                  if (!id || !context_.current.session()) return;
                                  add(menu, tr("Leave out submap %1…").arg(named(*id)),
                                      {submapsChoice({*id}), trajectoryChoice(id->trajectory)});
                                });
}

void LeaveOutController::addForClosure(QMenu* menu, const ClosureRow& row) {
  std::vector<LeaveOutChoice> choices;
  if (row.submap && row.node && row.kind == map::ConstraintKind::Inter)
    choices.push_back(closureChoice(*row.submap, *row.node));
  if (row.submap) {
    choices.push_back(submapsChoice({*row.submap}));
    choices.push_back(trajectoryChoice(row.submap->trajectory));
  }
  menu->addSeparator();
  add(*menu, tr("Leave out…"), std::move(choices));
}

void LeaveOutController::addForSubmaps(QMenu* menu, const std::vector<map::SubmapId>& ids, bool whole) {
  std::vector<LeaveOutChoice> choices;
  const bool one_trajectory = ids.front().trajectory == ids.back().trajectory;  // ascending
  if (one_trajectory) choices.push_back(trajectoryChoice(ids.front().trajectory));
  if (!whole || !one_trajectory) choices.insert(choices.begin(), submapsChoice(ids));
  menu->addSeparator();
  add(*menu, tr("Leave out…"), std::move(choices));
}

void LeaveOutController::add(QMenu& menu, const QString& text, std::vector<LeaveOutChoice> choices) {
  session::Session* const session = context_.current.session();
  const bool is_file = session && !robot::slamFileOf(session->robot()).isEmpty();
  const bool may = is_file && !choices.empty();
  QAction* const action = menu.addAction(themedIcon(QStringLiteral("remove")), text, this,
                                         [this, choices = std::move(choices)] { ask(choices); });
  action->setObjectName(QStringLiteral("leaveOut"));
  action->setToolTip(tr("Write a new state file without it. The present one stays as it is."));
  allow(action, may,
        is_file ? tr("The pose graph has not been read yet.")
                : tr("Only a Cartographer state file (.pbstream) that is open can be written again without "
                     "something, and this is none. Some robots give theirs: see \"Its submaps\" in the Maps "
                     "panel."));
  menu.setToolTipsVisible(true);
}

void LeaveOutController::ask(const std::vector<LeaveOutChoice>& choices) {
  session::Session* const session = context_.current.session();
  const QString from = session ? robot::slamFileOf(session->robot()) : QString();
  if (from.isEmpty()) return;
  delete dialog_;
  dialog_ = new LeaveOutDialog(
      from, choices,
      folderToWriteInto({QFileInfo(from).absolutePath(), context_.settings.value(kFolderKey).toString(),
                         QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}),
      context_.workers, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &LeaveOutDialog::written, this, [this](const QString& path) {
    context_.settings.setValue(kFolderKey, QFileInfo(path).absolutePath());
  });
  connect(dialog_, &LeaveOutDialog::openWanted, this, &LeaveOutController::openWanted);
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_leave_out_controller.cpp"
