#include "ui/window/diagnostics_dialog.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/window/support_text.h"
#include "ui/window/work_settings.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr int kLookEveryMs = 1'000;

using Row = QStringList;
struct Table {
  Row head;
  QList<Row> rows;
};

QString megabytes(std::size_t bytes) {
  return QString::number(double(bytes) / double(std::size_t(1) << 20), 'f', 1);
}

Table threadsOf(const Diagnostics& now) {
  return {{QCoreApplication::translate("window", "Background work"),
           QCoreApplication::translate("window", "Threads"), QCoreApplication::translate("window", "Busy"),
           QCoreApplication::translate("window", "Waiting")},
          {{QCoreApplication::translate("window", "Jobs"), QString::number(now.threads),
            QString::number(now.running), QString::number(now.waiting)}}};
}

Table memoryOf(const Diagnostics& now) {
  const auto row = [](const QString& what, std::size_t held, std::size_t allowed) {
    return Row{what, megabytes(held), megabytes(allowed)};
  };
  const work::Budgets &held = now.held, &allowed = now.allowed;
  return {
      {QCoreApplication::translate("window", "Kept in memory, MiB"),
       QCoreApplication::translate("window", "Held"), QCoreApplication::translate("window", "Allowed")},
      {row(QCoreApplication::translate("window", "Cells of submaps"), held.textures, allowed.textures),
       row(QCoreApplication::translate("window", "Cells of submaps, prepared for drawing"), held.dense,
           allowed.dense),
       row(QCoreApplication::translate("window", "Tiles of submaps"), held.tiles, allowed.tiles),
       row(QCoreApplication::translate("window", "Tiles of maps and costmaps"), held.grid_tiles,
           allowed.grid_tiles),
       row(QCoreApplication::translate("window", "Cells of maps, unpacked"), held.unpacked, allowed.unpacked),
       row(QCoreApplication::translate("window", "Cells of maps by regions"), held.regions, allowed.regions),
       row(QCoreApplication::translate("window", "All"), held.all(), allowed.all())}};
}

Table messagesOf(const robot::Reception& now) {
  return {{QCoreApplication::translate("window", "Messages of the robot"),
           QCoreApplication::translate("window", "Count")},
          {{QCoreApplication::translate("window", "Came"), countText(now.came)},
           {QCoreApplication::translate("window", "Dropped for newer ones"), countText(now.dropped)},
           {QCoreApplication::translate("window", "More than a second late"), countText(now.late)}}};
}

Table transformsOf(const robot::Reception& now) {
  constexpr int kMost = 8;
  Table table{{QCoreApplication::translate("window", "Transforms, oldest first"),
               QCoreApplication::translate("window", "Age, s")},
              {}};
  for (const robot::Reception::TransformAge& one : now.transforms) {
    if (table.rows.size() == kMost) {
      const auto more = qsizetype(now.transforms.size()) - kMost;
      const int form = sentences::formOf(more);
      table.rows << Row{
          sentences::counted(QCoreApplication::translate("window", "%1 more are not listed.", nullptr, form),
                             more),
          QString()};
      break;
    }
    table.rows << Row{QCoreApplication::translate("window", "%1 in %2")
                          .arg(plainWords(one.child, 60), plainWords(one.parent, 60)),
                      QString::number(one.age_s, 'f', 1)};
  }
  return table;
}

/// Numbers as they are, so that they fit in a column.
Table stallsOf(const Stalls& now) {
  Table table{{QCoreApplication::translate("window", "The window was busy for"),
               QCoreApplication::translate("window", "Times")},
              {}};
  for (std::size_t i = 0; i < now.counts().size(); ++i) {
    table.rows << Row{
        i < Stalls::kBelowMs.size()
            ? QCoreApplication::translate("window", "less than %1 ms").arg(Stalls::kBelowMs[i])
            : QCoreApplication::translate("window", "%1 ms and longer").arg(Stalls::kBelowMs.back()),
        countText(qint64(now.counts()[i]))};
  }
  const double longest_ms = std::chrono::duration<double, std::milli>(now.longest()).count();
  table.rows << Row{QCoreApplication::translate("window", "Longest, ms (%1)").arg(now.duringLongest().text()),
                    QString::number(longest_ms, 'f', 1)};
  return table;
}

QList<Table> tablesOf(const Diagnostics& now) {
  QList<Table> tables{threadsOf(now), memoryOf(now)};
  if (now.stalls) tables << stallsOf(*now.stalls);
  if (now.reception) tables << messagesOf(*now.reception);
  if (now.reception && !now.reception->transforms.empty()) tables << transformsOf(*now.reception);
  return tables;
}

}  // namespace

QString textOf(const Diagnostics& diagnostics) {
  QStringList lines;
  for (const Table& table : tablesOf(diagnostics)) {
    if (!lines.isEmpty()) lines << QString();
    lines << table.head.join(QLatin1Char('\t'));
    for (const Row& row : table.rows) lines << row.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n'));
}

DiagnosticsDialog::DiagnosticsDialog(std::function<Diagnostics()> look, QSettings& settings, QWidget* parent)
    : QDialog(parent),
      look_(std::move(look)),
      settings_(settings),
      threads_(new WholeBox(this)),
      memory_(new WholeBox(this)),
      copy_(new QPushButton(tr("&Copy diagnostics"), this)) {
  setObjectName(QStringLiteral("diagnostics"));
  setWindowTitle(tr("Diagnostics"));
  auto* const column = column_ = new QVBoxLayout(this);
  column->setContentsMargins(20, 16, 20, 16);
  column->setSpacing(16);
  layOut();

  const KeptWorkSettings kept = workSettingsIn(settings_);
  threads_->setRange(0, WorkSettings::kMostThreads);
  threads_->setSpecialValueText(tr("One per processor"));
  threads_->setValue(kept.settings.threads);
  // One below the minimum means the default.
  memory_->setRange(WorkSettings::kLeastMb - 1, WorkSettings::kMostMb);
  memory_->setSingleStep(64);
  memory_->setSuffix(tr(" MiB"));
  memory_->setSpecialValueText(tr("Default (%1 MiB)").arg(WorkSettings::kUsualMb));
  if (kept.settings.budget_mb > 0) memory_->setValue(kept.settings.budget_mb);
  auto* const form = new QGridLayout;
  form->setHorizontalSpacing(24);
  auto* const from_next = new PlainLabel(tr("Takes effect at the next start"), this);
  from_next->setSecondary(true);
  form->addWidget(from_next, 0, 0, 1, 2);
  int row = 1;
  for (const auto& [text, box] : {std::pair(tr("&Threads"), threads_), std::pair(tr("&Memory"), memory_)}) {
    auto* const label = new QLabel(text, this);
    label->setBuddy(box);
    box->setKeyboardTracking(false);
    form->addWidget(label, row, 0);
    form->addWidget(box, row++, 1);
    connect(box, &QSpinBox::valueChanged, this, &DiagnosticsDialog::keep);
  }
  form->setColumnStretch(0, 1);
  column->addLayout(form);
  for (const QString& sentence : kept.nonsense) column->addWidget(wrappedLabel(sentence, this));
  column->addStretch();

  auto* const close = new QPushButton(tr("Close"), this);
  close->setObjectName(QStringLiteral("secondary"));
  for (QPushButton* button : {close, copy_}) button->setAutoDefault(false);  // Enter ends typing a number
  copy_->setObjectName(QStringLiteral("secondary"));
  column->addLayout(rowOf({LayoutItem::rest(), copy_, close}));
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  copy_->setToolTip(leftOutSentence());
  connect(copy_, &QPushButton::clicked, this, &DiagnosticsDialog::copyWanted);
  auto* const again = new QTimer(this);
  connect(again, &QTimer::timeout, this, &DiagnosticsDialog::refresh);
  again->start(kLookEveryMs);
  setMinimumWidth(520);
}

QString DiagnosticsDialog::text() const { return textOf(look_()); }

void DiagnosticsDialog::layOut() {
  delete tables_;
  tables_ = new QWidget(this);
  column_->insertWidget(0, tables_);
  cells_.clear();
  rows_.clear();
  auto* const below = new QVBoxLayout(tables_);
  below->setContentsMargins(0, 0, 0, 0);
  below->setSpacing(16);
  for (const Table& table : tablesOf(look_())) {
    auto* const grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(0);
    int row = 0;
    for (const Row& cells : QList<Row>{table.head} + table.rows) {
      for (int i = 0; i < cells.size(); ++i) {
        auto* const cell = new PlainLabel(cells[i], tables_);
        cell->setSecondary(row == 0);
        if (i > 0) {
          cell->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
          cell->setSample(QStringLiteral("1,048,576.0"));
        }
        grid->addWidget(cell, row, i);
        cells_ << cell;
      }
      ++row;
    }
    grid->setColumnStretch(0, 1);
    below->addLayout(grid);
    rows_ << table.rows.size();
  }
}

void DiagnosticsDialog::refresh() {
  const QList<Table> tables = tablesOf(look_());
  QList<qsizetype> rows;
  for (const Table& table : tables) rows << table.rows.size();
  if (rows != rows_) {
    layOut();
    adjustSize();
    return;
  }
  auto cell = cells_.begin();
  for (const Table& table : tables) {
    for (const Row& cells : QList<Row>{table.head} + table.rows) {
      for (const QString& text : cells) (*cell++)->setText(text);
    }
  }
}

void DiagnosticsDialog::keep() {
  const int mb = memory_->value();
  keepWorkSettings(settings_, {threads_->value(), mb < WorkSettings::kLeastMb ? 0 : mb});
}

}  // namespace mapwright::ui

#include "moc_diagnostics_dialog.cpp"
