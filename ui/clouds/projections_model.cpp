#include "ui/clouds/projections_model.h"

#include <QFont>

#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

/// The value of a column with numbers.
double& numberIn(map::Projection& one, int column) {
  switch (column) {
    case ProjectionsModel::X:
      return one.corner_m.x();
    case ProjectionsModel::Y:
      return one.corner_m.y();
    case ProjectionsModel::Width:
      return one.size_m.x();
    case ProjectionsModel::Height:
      return one.size_m.y();
    case ProjectionsModel::MinZ:
      return one.min_z_m;
    default:
      return one.max_z_m;
  }
}

struct ColumnTexts {
  const char *head, *tip;
};
constexpr ColumnTexts kColumnTexts[] = {
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "X"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Of the lower left corner, metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Y"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Of the lower left corner, metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "W"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Width, metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "H"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Height on the map, metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "z from"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "to"),
     QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Metres")},
    {QT_TRANSLATE_NOOP("mapwright::ui::ProjectionsModel", "Frame"), ""}};

/// To the centimetre, without trailing zeros, so that all columns fit.
QString shortNumber(double value) {
  QString text = QString::number(value, 'f', 2);
  while (text.contains(QLatin1Char('.')) &&
         (text.endsWith(QLatin1Char('0')) || text.endsWith(QLatin1Char('.')))) {
    const bool point = text.endsWith(QLatin1Char('.'));
    text.chop(1);
    if (point) break;
  }
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

}  // namespace

QString flawText(map::ProjectionFlaw flaw) {
  switch (flaw) {
    case map::ProjectionFlaw::None:
      break;
    case map::ProjectionFlaw::NotFinite:
      return ProjectionsModel::tr("One of its values is not a number.");
    case map::ProjectionFlaw::TooFar:
      return ProjectionsModel::tr("It is more than 10,000 km away.");
    case map::ProjectionFlaw::WithoutSize:
      return ProjectionsModel::tr("Its width and height must be greater than 0.");
    case map::ProjectionFlaw::HeightsCrossed:
      return ProjectionsModel::tr("Its lower height must be below its upper height.");
  }
  return {};
}

ProjectionsModel::ProjectionsModel(const ProjectionDraft* draft, QObject* parent)
    : QAbstractTableModel(parent), draft_(draft) {}

int ProjectionsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int ProjectionsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ProjectionsModel::data(const QModelIndex& index, int role) const {
  const auto& all = draft_->wanted();
  if (!index.isValid() || index.row() >= int(all.size())) return {};
  map::Projection one = all[std::size_t(index.row())];
  const bool numeric = index.column() != Frame;
  switch (role) {
    case Qt::DisplayRole:
      if (numeric) return shortNumber(numberIn(one, index.column()));
      return one.frame.empty() ? tr("of the map") : words::plainName(one.frame);
    case Qt::EditRole:
      if (numeric) return numberIn(one, index.column());
      return QString::fromStdString(one.frame);
    case Qt::TextAlignmentRole:
      return numeric ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ToolTipRole: {
      const QString flaw = flawText(map::flawOf(one));
      return flaw.isEmpty() ? QVariant() : flaw.toHtmlEscaped();
    }
    case Qt::FontRole: {
      // Not confirmed by the robot yet.
      const auto& told = draft_->told();
      const bool known = told && index.row() < int(told->size()) && (*told)[std::size_t(index.row())] == one;
      QFont font;
      font.setItalic(!known);
      return font;
    }
    default:
      return {};
  }
}

QVariant ProjectionsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role == Qt::DisplayRole && orientation == Qt::Vertical) return QString::number(section);
  if (orientation == Qt::Vertical) return {};
  if (section < 0 || section >= kColumns) return {};
  const ColumnTexts& texts = kColumnTexts[section];
  if (role == Qt::DisplayRole) return tr(texts.head);
  return role == Qt::ToolTipRole && *texts.tip ? QVariant(tr(texts.tip)) : QVariant();
}

bool ProjectionsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto& all = draft_->wanted();
  if (role != Qt::EditRole || !editable_ || !index.isValid() || index.row() >= int(all.size())) return false;
  map::Projection one = all[std::size_t(index.row())];
  if (index.column() == Frame) {
    one.frame = value.toString().trimmed().toStdString();
  } else {
    bool ok = false;
    const double number = value.toDouble(&ok);
    if (!ok) return false;
    numberIn(one, index.column()) = number;
  }
  if (one != all[std::size_t(index.row())]) Q_EMIT edited(index.row(), one);
  return true;
}

Qt::ItemFlags ProjectionsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return editable_ && index.isValid() ? flags | Qt::ItemIsEditable : flags;
}

void ProjectionsModel::setEditable(bool editable) { editable_ = editable; }

void ProjectionsModel::refresh() {
  const int now = int(draft_->wanted().size());
  if (now > rows_) {
    beginInsertRows({}, rows_, now - 1);
    rows_ = now;
    endInsertRows();
  } else if (now < rows_) {
    beginRemoveRows({}, now, rows_ - 1);
    rows_ = now;
    endRemoveRows();
  }
  if (rows_ > 0) Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, kColumns - 1));
}

}  // namespace mapwright::ui

#include "moc_projections_model.cpp"
