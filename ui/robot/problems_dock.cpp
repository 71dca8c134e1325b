#include "ui/robot/problems_dock.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/wrapping_row.h"

namespace mapwright::ui {

ProblemsDock::ProblemsDock(QWidget* parent)
    : QDockWidget(tr("Problems"), parent),
      model_(new ProblemsModel(this)),
      table_(new QuietTableView(this)),
      summary_(new PlainLabel(this)),
      copy_selected_(compactButton(tr("Copy selected"), this)),
      copy_all_(compactButton(tr("Copy all"), this)),
      clear_(compactButton(tr("Clear"), this)),
      retry_(compactButton(tr("Retry"), this)) {
  setObjectName(QStringLiteral("problems"));
  showRows(*table_, model_, tr("Problems"));
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->installEventFilter(this);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->resizeSection(ProblemsModel::TimeColumn,
                        fontMetrics().horizontalAdvance(QStringLiteral("00:00:00")) + 40);
  header->resizeSection(ProblemsModel::CountColumn, 64);
  header->resizeSection(ProblemsModel::DurationColumn,
                        fontMetrics().horizontalAdvance(QStringLiteral("59 min 59 s")) + 16);
  header->resizeSection(ProblemsModel::SubjectColumn, 150);
  new NameColumn(
      table_, header, ProblemsModel::SentenceColumn,
      {{ProblemsModel::DurationColumn},
       {ProblemsModel::CountColumn},
       // It has the mark of the severity. Sentences are longer than any dock: they always give way.
       {.column = ProblemsModel::TimeColumn, .may_go = false},
       {ProblemsModel::SubjectColumn, 90}});

  auto* body = new QWidget(this);
  summary_->setSample(QStringLiteral("x"));
  summary_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  retry_->setIcon(themedIcon(QStringLiteral("retry")));
  copy_all_->setIcon(themedIcon(QStringLiteral("copy")));
  clear_->setIcon(themedIcon(QStringLiteral("trash")));
  retry_->setToolTip(tr("Repeat the requests for everything that failed or was missing"));
  auto* const tools = new WrappingRow;
  tools->add(summary_, 1, 120);
  for (QPushButton* button : {retry_, copy_selected_, copy_all_, clear_}) tools->add(button);
  body->setLayout(columnOf({{table_, 1}, tools}, 0, QMargins()));
  setWidget(body);

  connect(retry_, &QPushButton::clicked, this, &ProblemsDock::retryWanted);
  connect(copy_selected_, &QPushButton::clicked, this, &ProblemsDock::copySelected);
  connect(copy_all_, &QPushButton::clicked, this, [this] {
    if (session_)
      Q_EMIT copyWanted(session_->problems().toText(QDateTime::currentDateTime()), tr("All problems copied"));
  });
  connect(clear_, &QPushButton::clicked, this, [this] {
    if (session_) session_->clearProblems();
    refresh();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { copy_selected_->setEnabled(table_->selectionModel()->hasSelection()); });
  refresh();
}

ProblemsDock::~ProblemsDock() {
  // As in the inspector: the table is destroyed later than the object it reports to.
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void ProblemsDock::setSession(session::Session* session) {
  if (session_) session_->disconnect(this);
  session_ = session;
  if (session) connect(session, &session::Session::problemsChanged, this, &ProblemsDock::refresh);
  refresh();
}

void ProblemsDock::refresh() {
  const QScrollBar* bar = table_->verticalScrollBar();
  const bool at_end = bar->value() == bar->maximum();
  static const session::ProblemLog::Rows kNone;
  model_->sync(session_ ? session_->problems().rows() : kNone);
  if (at_end) table_->scrollToBottom();
  const int rows = model_->rowCount();
  QString text = tr("No problems.");
  if (rows > 0) {
    text = tr("%1, %2 unresolved").arg(problemsText(rows), countText(session_->problems().unresolved()));
    const std::size_t forgotten = session_->problems().forgotten();
    if (forgotten > 0) text += tr(", %1 older ones dropped").arg(countText(qint64(forgotten)));
  }
  summary_->setText(text);
  copy_all_->setEnabled(rows > 0);
  clear_->setEnabled(rows > 0);
  retry_->setEnabled(session_);
  copy_selected_->setEnabled(table_->selectionModel()->hasSelection());
}

void ProblemsDock::copySelected() {
  QStringList lines;
  QModelIndexList rows = table_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.row() < b.row(); });
  for (const QModelIndex& row : rows) lines << problemLine(model_->problem(row.row()));
  if (lines.isEmpty()) return;
  Q_EMIT copyWanted(lines.join(QLatin1Char('\n')),
                    sentences::counted(tr("%1 problems copied", nullptr, int(lines.size())), lines.size()));
}

bool ProblemsDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    copySelected();
    return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_problems_dock.cpp"
