#include "ui/replay/range_export_dialog.h"

#include <cmath>
#include <iterator>
#include <utility>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>

#include "excerpt/time_typed.h"
#include "jobs/export_map.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

struct KindChoice {
  excerpt::Kind kind;
  const char* suffix;
  const char* text;
};
constexpr KindChoice kKindChoices[] = {
    {excerpt::Kind::Mcap, ".mcap",
     QT_TRANSLATE_NOOP("mapwright::ui::RangeExportDialog", "Messages, can be replayed (MCAP)")},
    {excerpt::Kind::Lines, ".jsonl",
     QT_TRANSLATE_NOOP("mapwright::ui::RangeExportDialog", "Messages, one per line (JSON lines)")},
    {excerpt::Kind::TrackGeoJson, ".geojson",
     QT_TRANSLATE_NOOP("mapwright::ui::RangeExportDialog", "Path of the robot (GeoJSON)")},
    {excerpt::Kind::TrackCsv, ".csv",
     QT_TRANSLATE_NOOP("mapwright::ui::RangeExportDialog", "Path of the robot (CSV)")},
    {excerpt::Kind::TrackTum, ".tum",
     QT_TRANSLATE_NOOP("mapwright::ui::RangeExportDialog", "Path of the robot (TUM)")}};

QString fileNameOf(const QString& bag) {
  QString name = QFileInfo(words::plainName(bag)).completeBaseName();
  static const QRegularExpression odd(QStringLiteral("[^\\w\\-. ]"),
                                      QRegularExpression::UseUnicodePropertiesOption);
  name.replace(odd, QStringLiteral("_"));
  name = name.left(60).trimmed();
  while (name.startsWith(QLatin1Char('.'))) name.remove(0, 1);
  return name.isEmpty() ? QStringLiteral("bag") : name;
}

/// Quotes any text as one word of a shell.
QString shellWord(const QString& text) {
  QString word = words::plainLine(text);
  word.replace(QLatin1Char('\''), QStringLiteral("'\\''"));
  return QLatin1Char('\'') + word + QLatin1Char('\'');
}

QString timeWord(double at_s) { return QStringLiteral("%1T%2Z").arg(dayText(at_s), clockText(at_s)); }

QString shownDayTime(double at_s) { return QStringLiteral("%1 %2").arg(dayText(at_s), clockText(at_s)); }

}  // namespace

QString filmCommand(const RangeOffer& offer, double from_s, double to_s) {
  QStringList command{QStringLiteral("mapwright"), QStringLiteral("bags"), QStringLiteral("film")};
  if (offer.source.recording.empty()) {
    command << shellWord(offer.name) << QStringLiteral("--robot") << shellWord(offer.address);
  } else {
    command << shellWord(QString::fromStdString(offer.source.recording));
  }
  command << QStringLiteral("--from") << timeWord(from_s) << QStringLiteral("--to") << timeWord(to_s)
          << QStringLiteral("-o") << QStringLiteral("film.mp4");
  return command.join(QLatin1Char(' '));
}

RangeExportDialog::RangeExportDialog(RangeOffer offer, QWidget* parent)
    : QDialog(parent),
      offer_(std::move(offer)),
      from_(new QLineEdit(this)),
      to_(new QLineEdit(this)),
      path_(new QLineEdit(this)),
      film_(new QLineEdit(this)),
      kind_(new QComboBox(this)),
      from_here_(new QPushButton(tr("From here"), this)),
      to_here_(new QPushButton(tr("To here"), this)),
      browse_(new QPushButton(tr("&Browse…"), this)),
      export_(new QPushButton(tr("Export"), this)),
      close_(new QPushButton(tr("Cancel"), this)),
      progress_(new QProgressBar(this)),
      said_(new QLabel(this)) {
  setWindowTitle(tr("Export a range of the bag"));
  setMinimumWidth(560);
  for (const KindChoice& choice : kKindChoices) kind_->addItem(tr(choice.text), int(choice.kind));
  from_s_ = offer_.loop ? offer_.loop->from_s : offer_.first_s;
  to_s_ = offer_.loop ? offer_.loop->until_s : offer_.last_s;
  from_shown_ = shownDayTime(from_s_);
  to_shown_ = shownDayTime(to_s_);
  from_->setText(from_shown_);
  to_->setText(to_shown_);
  const QString how =
      plainToolTip(tr("The time (UTC):\n14:36:17.5, 2023-10-31 14:36:17, +1:30 after the start, "
                      "-10 before the end"));
  from_->setToolTip(how);
  to_->setToolTip(how);
  film_->setReadOnly(true);
  film_->setAccessibleName(tr("Command that makes a video of this range"));
  path_->setText(QDir(offer_.folder).filePath(fileNameOf(offer_.name)));
  layOut();

  for (const auto& [here, edit] : {std::pair(from_here_, from_), std::pair(to_here_, to_)})
    connect(here, &QPushButton::clicked, edit,
            [this, edit = edit] { edit->setText(shownDayTime(offer_.now())); });
  connect(kind_, &QComboBox::currentIndexChanged, this, &RangeExportDialog::applyKind);
  for (QLineEdit* const edit : {from_, to_})
    connect(edit, &QLineEdit::textChanged, this, &RangeExportDialog::applyRange);
  connect(path_, &QLineEdit::textEdited, this, [this] { say({}); });
  connect(browse_, &QPushButton::clicked, this, &RangeExportDialog::browse);
  connect(export_, &QPushButton::clicked, this, &RangeExportDialog::start);
  connect(close_, &QPushButton::clicked, this, &RangeExportDialog::reject);
  applyKind();
  applyRange();
}

RangeExportDialog::~RangeExportDialog() = default;

void RangeExportDialog::layOut() {
  giveRoles(*export_, {from_here_, to_here_, browse_, close_});
  makeLine(*progress_);
  said_->setTextFormat(Qt::PlainText);
  said_->setWordWrap(true);
  said_->hide();
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  const auto add_time = [&](const QString& name, QLineEdit* edit, QPushButton* here) {
    auto* const label = new QLabel(name, this);
    label->setBuddy(edit);
    here->setToolTip(tr("The time that the replay shows now"));
    here->setVisible(bool(offer_.now));
    form->addRow(label, rowOf({{edit, 1}, here}));
  };
  add_time(tr("F&rom (UTC)"), from_, from_here_);
  add_time(tr("&To (UTC)"), to_, to_here_);
  form->addRow(tr("&What"), kind_);
  auto* const path_label = new QLabel(tr("&File"), this);
  path_label->setBuddy(path_);
  form->addRow(path_label, rowOf({{path_, 1}, browse_}));
  form->addRow(tr("Video by &command"), film_);
  setLayout(columnOf({form, said_, progress_, rowOf({LayoutItem::rest(), close_, export_}, 8)}, 8,
                     QMargins(16, 16, 16, 16)));
  QWidget* const order[] = {from_, from_here_, to_, to_here_, kind_, path_, browse_, film_, close_, export_};
  for (std::size_t i = 1; i < std::size(order); ++i) setTabOrder(order[i - 1], order[i]);
}

QString RangeExportDialog::said() const { return said_->isHidden() ? QString() : said_->text(); }

void RangeExportDialog::say(const QString& sentence, bool bad) {
  asked_.clear();
  letEnterPress(*export_, true);
  setTextColor(*said_, bad ? appColors().error_text : appColors().text);
  said_->setText(sentence);
  said_->setVisible(!sentence.isEmpty());
}

std::optional<double> RangeExportDialog::time(const QLineEdit* edit, const QString& shown,
                                              double meant_s) const {
  if (edit->text() == shown) return meant_s;
  return excerpt::timeTyped(edit->text(), offer_.first_s, offer_.last_s);
}

std::optional<excerpt::TimeSpan> RangeExportDialog::span() const {
  // The whole bag is more than its stated times.
  const bool all = !offer_.loop && from_->text() == from_shown_ && to_->text() == to_shown_;
  if (all) return excerpt::TimeSpan{};
  const auto from_s = time(from_, from_shown_, from_s_), to_s = time(to_, to_shown_, to_s_);
  if (!from_s || !to_s) return std::nullopt;
  return excerpt::TimeSpan{from_s, to_s};
}

void RangeExportDialog::applyRange() {
  say({});
  const auto from_s = time(from_, from_shown_, from_s_), to_s = time(to_, to_shown_, to_s_);
  film_->setText(from_s && to_s ? filmCommand(offer_, *from_s, *to_s) : QString());
  film_->setCursorPosition(0);
  film_->setToolTip(plainToolTip(film_->text()));
}

void RangeExportDialog::applyKind() {
  // The name stays, the extension follows the kind.
  QString path = path_->text();
  for (const KindChoice& choice : kKindChoices) {
    if (!path.endsWith(QLatin1String(choice.suffix), Qt::CaseInsensitive)) continue;
    path.chop(int(qstrlen(choice.suffix)));
    break;
  }
  path_->setText(path + QLatin1String(kKindChoices[kind_->currentIndex()].suffix));
  say({});
}

void RangeExportDialog::browse() {
  const QString suffix = QLatin1String(kKindChoices[kind_->currentIndex()].suffix);
  QString path = QFileDialog::getSaveFileName(this, tr("Export to"), path_->text(),
                                              QStringLiteral("%1 (*%2)").arg(kind_->currentText(), suffix));
  if (path.isEmpty()) return;
  const bool named = path.endsWith(suffix, Qt::CaseInsensitive);
  if (!named) path += suffix;
  path_->setText(path);
  say({});
  if (named) asked_ = path;  // the file dialog has asked
}

std::optional<QString> RangeExportDialog::unavailableReason(const QString& path) const {
  const auto wanted = span();
  if (!wanted)
    return tr("From and to must be times between %1 and %2.")
        .arg(shownDayTime(offer_.first_s), shownDayTime(offer_.last_s));
  if (wanted->from_s && *wanted->to_s < *wanted->from_s) return tr("The end is before the start.");
  if (path_->text().trimmed().isEmpty()) return tr("Enter a file name.");
  const QFileInfo about(path);
  if (about.isDir()) return tr("%1 is a folder. Enter a file name.").arg(QDir::toNativeSeparators(path));
  if (!about.dir().exists())
    return tr("The folder %1 does not exist.").arg(QDir::toNativeSeparators(about.absolutePath()));
  if (!offer_.source.recording.empty() && !jobs::firstOwnSource({path}, {offer_.source.recording}).isEmpty())
    return tr("%1 is the recording being played. Choose another name.").arg(QDir::toNativeSeparators(path));
  return std::nullopt;
}

void RangeExportDialog::start() {
  if (job_ || left_) return;
  const QString path = QFileInfo(path_->text().trimmed()).absoluteFilePath();
  if (const auto why = unavailableReason(path)) return say(*why);
  if (QFileInfo::exists(path) && asked_ != path) {
    say(tr("%1 already exists. Press Export again to replace it.").arg(QDir::toNativeSeparators(path)));
    asked_ = path;
    letEnterPress(*export_, false);
    return;
  }
  excerpt::Order order;
  order.kind = excerpt::Kind(kind_->currentData().toInt());
  order.path = path.toStdString();
  order.existing = disk::existingNow(order.path);
  order.span = *span();
  order.address = offer_.address.toStdString();
  order.robot_kind = offer_.robot_kind;
  order.bag = offer_.source.key.name;
  say({});
  job_ = std::make_unique<excerpt::ExcerptJob>(offer_.source, std::move(order), offer_.workers);
  connect(job_.get(), &excerpt::ExcerptJob::progressed, this,
          [this](double share) { progress_->setValue(int(share * 1000)); });
  connect(job_.get(), &excerpt::ExcerptJob::ended, this, &RangeExportDialog::onEnded);
  setRunning(true);
  job_->start();
}

void RangeExportDialog::setRunning(bool running) {
  for (QWidget* const widget : std::initializer_list<QWidget*>{from_, to_, kind_, path_, browse_, export_})
    widget->setEnabled(!running && !left_);
  progress_->setValue(0);
  progress_->setVisible(running);
  close_->setEnabled(true);
  close_->setText(running ? tr("Cancel") : tr("Close"));
}

void RangeExportDialog::onEnded(const excerpt::Ended& ended) {
  const QString path = path_->text().trimmed();
  // It is emitting this signal.
  job_.release()->deleteLater();
  setRunning(false);
  if (ended.not_read) {
    const QString why = QString::fromStdString(sentences::sentenceOf(*ended.not_read));
    say(ended.range ? tr("Nothing was written: %1 to %2 could not be read. %3")
                          .arg(clockText(*ended.range->from_s, 0), clockText(*ended.range->to_s, 0), why)
                    : tr("Nothing was written. %1").arg(why));
  } else if (ended.not_written) {
    say(sentences::sentenceOf(*ended.not_written));
  } else if (!ended.written) {
    say(tr("Cancelled. Nothing was written."));
  } else {
    const excerpt::Written& done = *ended.written;
    const excerpt::Kind kind = excerpt::Kind(kind_->currentData().toInt());
    const bool messages = kind == excerpt::Kind::Mcap || kind == excerpt::Kind::Lines;
    const QString what =
        messages
            ? sentences::counted(tr("%1 messages", nullptr, sentences::formOf(done.messages)), done.messages)
            : sentences::counted(tr("%1 poses", nullptr, sentences::formOf(done.samples)), done.samples);
    const QString sentence = tr("Exported %1 to %2").arg(what, QDir::toNativeSeparators(path));
    QStringList lacks;
    if (done.odd > 0)
      lacks << tr("Messages left out because they have no time stamp or cannot be read: %1.").arg(done.odd);
    if (!ended.holes.empty()) lacks << sentences::sentenceOf(replay::faultOf(ended.holes));
    for (const Fault& loss : done.losses) lacks << sentences::sentenceOf(loss);
    Q_EMIT exported(QFileInfo(path).absoluteFilePath(), sentence);
    if (lacks.isEmpty()) return accept();
    lacks.prepend(words::asSentence(sentence));
    constexpr qsizetype kMostSaid = 6;
    const qsizetype more = lacks.size() - kMostSaid;
    if (more > 0) lacks = lacks.mid(0, kMostSaid) << tr("and %1 more").arg(more);
    say(lacks.join(QLatin1Char('\n')));
  }
}

void RangeExportDialog::leaveBag() {
  if (left_) return;
  left_ = true;
  const bool was_running = job_ != nullptr;
  job_.reset();
  setRunning(false);
  film_->setEnabled(false);
  say(was_running ? tr("The bag was closed before the export finished. Nothing was written.")
                  : tr("The bag is no longer open."));
}

void RangeExportDialog::reject() {
  if (job_) {
    job_->cancel();
    close_->setEnabled(false);
    return;
  }
  QDialog::reject();
}

}  // namespace mapwright::ui

#include "moc_range_export_dialog.cpp"
