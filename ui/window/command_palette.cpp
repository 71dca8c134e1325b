#include "window/command_palette.h"

#include <algorithm>

#include <QApplication>
#include <QCollator>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {

namespace {

constexpr int kKeysRole = Qt::UserRole + 1;
constexpr int kMenuRole = Qt::UserRole + 2;
constexpr int kFindingRole = Qt::UserRole + 3;

/// Name on the left, menu and keys on the right.
class CommandDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(), 28};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const UiColors colors = appColors();
    QRect right = option.rect.adjusted(0, 0, -10, 0);
    painter->setPen(colors.secondary_text);
    const QString keys = index.data(kKeysRole).toString();
    painter->drawText(right, Qt::AlignRight | Qt::AlignVCenter, keys);
    right.setRight(right.right() - 90);
    painter->drawText(right, Qt::AlignRight | Qt::AlignVCenter, index.data(kMenuRole).toString());
  }
};

}  // namespace

std::optional<int> fuzzyScore(const QString& pattern, const QString& text) {
  int score = 0;
  qsizetype at = -1;
  bool run = false;
  for (const QChar wanted : pattern) {
    if (wanted.isSpace()) {
      run = false;
      continue;
    }
    // Prefers the beginning of a word to the next matching letter.
    qsizetype found = -1;
    for (qsizetype i = at + 1; i < text.size(); ++i) {
      if (text[i].toLower() != wanted.toLower()) continue;
      const bool starts_word = i == 0 || !text[i - 1].isLetterOrNumber();
      if (found < 0) found = i;
      if (starts_word || (run && i == at + 1)) {
        found = i;
        break;
      }
    }
    if (found < 0) return std::nullopt;
    const bool starts_word = found == 0 || !text[found - 1].isLetterOrNumber();
    score += 1 + (starts_word ? 8 : 0) + (run && found == at + 1 ? 6 : 0) + (found == 0 ? 4 : 0);
    at = found;
    run = true;
  }
  return score;
}

CommandPalette::CommandPalette(const Actions& actions, const Findings& findings, QWidget* parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint),
      actions_(actions),
      searches_(findings.begin()),
      field_(new QLineEdit(this)),
      list_(new QListWidget(this)) {
  setObjectName(QStringLiteral("card"));
  setWindowTitle(tr("Find"));
  resize(560, 380);
  field_->setPlaceholderText(tr("A command, or the name of an object, submap, map or topic"));
  field_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  field_->setMinimumHeight(32);
  field_->setAccessibleName(tr("Command or name"));
  field_->installEventFilter(this);
  list_->setItemDelegate(new CommandDelegate(list_));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setIconSize({18, 18});
  list_->setUniformItemSizes(true);
  setLayout(columnOf({field_, {list_, 1}}, 8, QMargins(8, 8, 8, 8)));
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::fill);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  if (parent) {
    const QPoint top = parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 96));
    move(top);
  }
  fill();
  field_->setFocus();
}

void CommandPalette::fill() {
  constexpr std::size_t kMostFound = 60;
  struct Hit {
    int score;
    const Actions::Entry* entry;  // null: `finding`
    std::size_t finding;
  };
  std::vector<Hit> hits;
  const QString typed = field_->text().simplified();
  for (const Actions::Entry& entry : actions_.entries()) {
    if (!entry.action->isVisible()) continue;
    const QString name = nameAlone(entry);
    // A menu's name also finds its actions, after those whose own name matches.
    std::optional<int> score = fuzzyScore(typed, name);
    if (!score) {
      score = fuzzyScore(typed, entry.menu + QLatin1Char(' ') + name);
      if (score) *score -= 100;
    }
    if (score) hits.push_back({*score - (entry.action->isEnabled() ? 0 : 1000), &entry, 0});
  }
  found_.clear();
  if (!typed.isEmpty()) {
    std::vector<std::pair<int, Finding>> findings;
    const QStringList words = typed.split(QLatin1Char(' '));
    const auto see = [&](Finding finding) {
      // Names are many: each word must be in it as it was typed.
      const auto has = [&](const QString& word) {
        return finding.text.contains(word, Qt::CaseInsensitive) ||
               finding.where.contains(word, Qt::CaseInsensitive);
      };
      if (!std::all_of(words.begin(), words.end(), has)) return;
      // The whole name, or its end as a whole word, is meant before what only begins like it.
      constexpr int kExact = 2000, kEnds = 1000;
      const bool exact = finding.text.compare(typed, Qt::CaseInsensitive) == 0;
      const bool ends = finding.text.endsWith(QLatin1Char(' ') + typed, Qt::CaseInsensitive);
      const int score = fuzzyScore(typed, finding.text).value_or(-100) + (exact ? kExact : ends ? kEnds : 0);
      findings.emplace_back(score, std::move(finding));
    };
    for (const Findings::Search& search : searches_) search(typed, see);
    QCollator as_people_count;
    as_people_count.setNumericMode(true);
    std::stable_sort(findings.begin(), findings.end(), [&](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first > b.first;
      return as_people_count.compare(a.second.text, b.second.text) < 0;
    });
    if (findings.size() > kMostFound) findings.resize(kMostFound);
    for (auto& [score, finding] : findings) {
      hits.push_back({score, nullptr, found_.size()});
      found_.push_back(std::move(finding));
    }
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.score > b.score; });
  list_->clear();
  QPixmap nothing(list_->iconSize());
  nothing.fill(Qt::transparent);
  const QIcon no_icon(nothing);
  for (const Hit& hit : hits) {
    if (!hit.entry) {
      const Finding& finding = found_[hit.finding];
      auto* item = new QListWidgetItem(finding.icon.isEmpty() ? no_icon : themedIcon(finding.icon),
                                       finding.text, list_);
      item->setData(kFindingRole, qulonglong(hit.finding));
      item->setData(kMenuRole, finding.where);
      continue;
    }
    QAction* action = hit.entry->action;
    // Names are aligned, with or without an icon.
    auto* item =
        new QListWidgetItem(action->icon().isNull() ? no_icon : action->icon(), nameAlone(*hit.entry), list_);
    item->setData(Qt::UserRole, QVariant::fromValue(static_cast<QObject*>(action)));
    item->setData(kKeysRole, shortcutsText(*action));
    item->setData(kMenuRole, hit.entry->menu);
    if (action->isCheckable() && action->isChecked()) item->setText(item->text() + tr("  (on)"));
    if (!action->isEnabled()) item->setFlags(Qt::NoItemFlags);
  }
  if (list_->count() == 0) {
    auto* item = new QListWidgetItem(tr("Nothing is called that"), list_);
    item->setFlags(Qt::NoItemFlags);
  } else {
    list_->setCurrentRow(0);
  }
}

void CommandPalette::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  const QVariant finding = item->data(kFindingRole);
  auto* action = qobject_cast<QAction*>(item->data(Qt::UserRole).value<QObject*>());
  const auto go = finding.isValid() ? found_[std::size_t(finding.toULongLong())].go : std::function<void()>();
  accept();
  if (action) action->trigger();
  if (go) go();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      run();
      return true;
    }
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
      QApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_command_palette.cpp"
