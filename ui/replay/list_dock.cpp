#include "ui/replay/list_dock.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/wrapping_row.h"

namespace mapwright::ui {

namespace {
constexpr int kSearchPx = 120, kSummaryPx = 120;
}

ListDock::ListDock(const QString& title, const QString& search, QWidget* parent)
    : QDockWidget(title, parent),
      search_(new QLineEdit(this)),
      table_(new QuietTableView(this)),
      summary_(new PlainLabel(this)),
      empty_(wrappedLabel({}, this)) {
  search_->setPlaceholderText(search);
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(search);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->installEventFilter(this);
  table_->horizontalHeader()->setHighlightSections(false);
  empty_->setContentsMargins(12, 8, 12, 8);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  summary_->setSample(QStringLiteral("x"));
  summary_->setSecondary(true);
  summary_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(table_, &QTableView::customContextMenuRequested, this, &ListDock::showMenu);
}

ListDock::~ListDock() { table_->removeEventFilter(this); }

void ListDock::layOut(QAbstractItemModel* rows, std::initializer_list<QWidget*> tools, int summary_stretch,
                      std::initializer_list<QPushButton*> buttons) {
  showRows(*table_, rows, windowTitle());
  auto* const body = new QWidget(this);
  auto* const row = new WrappingRow;
  row->add(search_, 1, kSearchPx);
  for (QWidget* const tool : tools) row->add(tool);
  row->add(summary_, summary_stretch, kSummaryPx);
  for (QPushButton* const button : buttons) {
    button->setObjectName(QStringLiteral("compact"));
    row->add(button);
  }
  body->setLayout(columnOf({row, {empty_, 1}, {table_, 1}}, 0, QMargins()));
  setWidget(body);
}

void ListDock::showInstead(const QString& sentence) {
  empty_->setText(sentence);
  empty_->setVisible(!sentence.isEmpty());
  table_->setVisible(sentence.isEmpty());
}

QString ListDock::summaryShown() const { return summary_->text(); }
QString ListDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }

}  // namespace mapwright::ui

#include "moc_list_dock.cpp"
