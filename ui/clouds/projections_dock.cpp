#include "ui/clouds/projections_dock.h"

#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr int kLeastColumnPx = 26;

/// Metres are typed into a box with limits; the frame into a line.
class NumberDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    if (index.column() == ProjectionsModel::Frame) {
      return QStyledItemDelegate::createEditor(parent, option, index);
    }
    auto* const box = new DecimalBox(parent);
    box->setFrame(false);
    box->setRange(-1e7, 1e7);
    box->setDecimals(3);
    box->setSingleStep(0.1);
    return box;
  }
};

}  // namespace

ProjectionsDock::ProjectionsDock(const ProjectionDraft* draft, QWidget* parent)
    : QDockWidget(tr("Projections"), parent),
      draft_(draft),
      model_(new ProjectionsModel(draft, this)),
      absence_(textLabel({}, this)),
      state_(textLabel({}, this)),
      outcome_(textLabel({}, this)),
      body_(new QWidget(this)),
      table_(new QTableView(body_)) {
  setObjectName(QStringLiteral("projections"));
  ask_ = compactButton(tr("Reload"), body_, tr("Ask the robot for its current projections"));
  add_ = compactButton(tr("Add"), body_, tr("Add a projection of the visible area"));
  draw_ = compactButton(tr("On the map"), body_, tr("Draw, select and move the rectangles on the map"));
  draw_->setCheckable(true);
  remove_ = compactButton(tr("Remove"), body_, tr("Remove the selected projection from the list (Delete)"));
  revert_ = compactButton(tr("Revert"), body_, tr("Back to the robot's projections"));
  send_ = compactButton(tr("Set on the robot"), body_);

  table_->setModel(model_);
  table_->setItemDelegate(new NumberDelegate(table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAccessibleName(tr("Projections"));
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  // A whole row should be visible: the frame, usually the same, gets the remaining width.
  table_->horizontalHeader()->setMinimumSectionSize(kLeastColumnPx);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(ProjectionsModel::Frame, QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->setMinimumHeight(90);

  auto* const unit = textLabel(tr("In metres; X and Y are those of the lower left corner."), body_);
  body_->setLayout(columnOf({unit,
                             {table_, 1},
                             rowOf({add_, draw_, remove_, LayoutItem::rest()}),
                             rowOf({send_, revert_, ask_, LayoutItem::rest()}),
                             state_,
                             outcome_},
                            6, QMargins(8, 8, 8, 8)));
  absence_->setContentsMargins(8, 4, 8, 4);

  auto* const all = new QWidget(this);
  all->setLayout(columnOf({absence_, {body_, 1}}, -1, QMargins()));
  all->setMinimumWidth(240);
  setWidget(all);

  connect(send_, &QPushButton::clicked, this, [this] {
    // It is disabled at once, and the focus would move to another dock.
    table_->setFocus();
    Q_EMIT sendWanted();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (!selecting_) Q_EMIT chosen(current.isValid() ? std::optional(current.row()) : std::nullopt);
          });
  setAbsence({});
  setOutcome({}, false);
  refresh();
}

void ProjectionsDock::setAbsence(const QString& sentence) {
  absence_->setText(sentence);
  absence_->setVisible(!sentence.isEmpty());
  body_->setVisible(sentence.isEmpty());
}

void ProjectionsDock::setOffer(const ProjectionsOffer& offer) {
  offer_ = offer;
  refresh();
}

void ProjectionsDock::setBusy(bool busy) {
  busy_ = busy;
  refresh();
}

void ProjectionsDock::setOutcome(const QString& sentence, bool bad) {
  outcome_->setText(sentence);
  outcome_->setVisible(!sentence.isEmpty());
  setTextColor(*outcome_, bad ? appColors().error_text : appColors().secondary_text);
}

void ProjectionsDock::setDrawing(bool drawing) { draw_->setChecked(drawing); }

void ProjectionsDock::refresh() {
  const bool editable = offer_.changes && !busy_;
  model_->setEditable(editable);
  {
    const QScopedValueRollback selecting(selecting_, true);
    model_->refresh();
    const int row = draft_->selected().value_or(-1);
    if (table_->currentIndex().row() != row) {
      const int column = std::max(0, table_->currentIndex().column());
      table_->setCurrentIndex(row < 0 ? QModelIndex() : model_->index(row, column));
      if (row < 0) table_->clearSelection();
    }
  }
  const std::optional<int> flawed = draft_->firstFlawed();
  add_->setEnabled(editable);
  draw_->setEnabled(offer_.changes || !draft_->wanted().empty());
  remove_->setEnabled(editable && draft_->selected());
  revert_->setEnabled(editable && draft_->told() && draft_->changed());
  ask_->setEnabled(offer_.online && offer_.reads && !busy_);
  send_->setEnabled(editable && offer_.online && draft_->changed() && !flawed);
  send_->setToolTip(!offer_.changes  ? tr("Projections cannot be set on this robot.")
                    : !offer_.online ? tr("The robot is not connected.")
                    : flawed         ? flawText(map::flawOf(draft_->wanted()[std::size_t(*flawed)]))
                                     : tr("Send the whole list; the robot's answer is shown afterwards"));
  QString state;
  if (busy_) {
    state = tr("Waiting for the robot…");
  } else if (!draft_->told() && !draft_->changed()) {
    state = offer_.reads ? tr("The robot has not reported its projections yet.")
                         : tr("This robot does not report its projections.");
  } else if (flawed) {
    state = tr("Projection %1 cannot be sent. %2")
                .arg(QString::number(*flawed), flawText(map::flawOf(draft_->wanted()[std::size_t(*flawed)])));
  } else if (draft_->changed()) {
    state = tr("Edited here, not set on the robot yet.");
  } else if (draft_->wanted().empty()) {
    state = tr("The robot has no projections.");
  } else {
    const auto count = qint64(draft_->wanted().size());
    state = sentences::counted(tr("The robot has %1 projections.", nullptr, sentences::formOf(count)), count);
  }
  if (!offer_.changes && offer_.reads) {
    state += QLatin1Char(' ') + tr("They are read-only here: the robot offers no service to set them.");
  }
  state_->setText(state);
}

}  // namespace mapwright::ui

#include "moc_projections_dock.cpp"
