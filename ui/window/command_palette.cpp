#include "ui/window/command_palette.h"

#include <algorithm>

#include <QApplication>
#include <QCollator>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>
#include <QStyledItemDelegate>

#include "sentences/plural.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr int kKeysRole = Qt::UserRole + 1;
constexpr int kMenuRole = Qt::UserRole + 2;
constexpr int kFindingRole = Qt::UserRole + 3;

/// Whether each word of `typed` begins a word of `name`, in the same order.
bool wordsBeginIn(const QString& typed, const QString& name) {
  static const QRegularExpression kBetween(QStringLiteral("[^\\w]+"),
                                           QRegularExpression::UseUnicodePropertiesOption);
  const QStringList words = name.split(kBetween, Qt::SkipEmptyParts);
  auto at = words.begin();
  for (const QString& each : typed.split(kBetween, Qt::SkipEmptyParts)) {
    at = std::find_if(at, words.end(), [&](const QString& word) { return word.startsWith(each); });
    if (at == words.end()) return false;
    ++at;
  }
  return true;
}

/// Name on the left, menu and keys on the right.
class CommandDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(), 28};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Columns columns(option, index);
    QStyleOptionViewItem left = option;
    left.rect.setRight(columns.name_right);
    // The background goes behind all of the row.
    option.widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
    QStyledItemDelegate::paint(painter, left, index);
    painter->setPen(appColors().secondary_text);
    painter->drawText(columns.keys, Qt::AlignRight | Qt::AlignVCenter, index.data(kKeysRole).toString());
    painter->drawText(columns.menu, Qt::AlignRight | Qt::AlignVCenter, index.data(kMenuRole).toString());
  }

 private:
  static constexpr int kGap = 12, kKeysAtLeast = 78;
  /// The keys stand in a column of their own where they fit; the name gets what is left, and is elided there.
  struct Columns {
    Columns(const QStyleOptionViewItem& option, const QModelIndex& index) {
      const auto widthOf = [&](int role) {
        return option.fontMetrics.horizontalAdvance(index.data(role).toString());
      };
      keys = option.rect.adjusted(0, 0, -10, 0);
      keys.setLeft(keys.right() - std::max(kKeysAtLeast, widthOf(kKeysRole)));
      menu = keys;
      menu.setRight(keys.left() - kGap);
      menu.setLeft(menu.right() - widthOf(kMenuRole));
      name_right = menu.left() - kGap;
    }
    QRect keys, menu;
    int name_right = 0;
  };
};

}  // namespace

std::optional<int> fuzzyScore(const QString& pattern, const QString& text) {
  constexpr int kEqual = 1500, kBegins = 800, kWords = 600, kContains = 400;
  constexpr int kLetter = 1, kWordStart = 8, kRun = 6, kFirst = 4;
  const QString typed = pattern.simplified().toLower(), name = text.toLower();
  // The best score with the letters so far, of which the last is at each position of the name.
  constexpr int kNone = -1;
  std::vector<int> best, before;
  bool run = false;
  for (const QChar wanted : typed) {
    if (wanted.isSpace()) {
      run = false;
      continue;
    }
    before.swap(best);
    best.assign(std::size_t(name.size()), kNone);
    int so_far = before.empty() ? 0 : kNone;  // the best that ends before the position
    for (qsizetype i = 0; i < name.size(); ++i) {
      const int neighbour = before.empty() || i == 0 ? kNone : before[std::size_t(i) - 1];
      so_far = std::max(so_far, neighbour);
      if (name[i] != wanted || so_far == kNone) continue;
      const bool starts_word = i == 0 || !name[i - 1].isLetterOrNumber();
      const int behind = run && neighbour != kNone ? std::max(so_far, neighbour + kRun) : so_far;
      best[std::size_t(i)] = behind + kLetter + (starts_word ? kWordStart : 0) + (i == 0 ? kFirst : 0);
    }
    run = true;
  }
  if (typed.isEmpty()) return 0;
  const int letters = best.empty() ? kNone : *std::max_element(best.begin(), best.end());
  if (letters == kNone) return std::nullopt;
  if (name == typed) return kEqual + letters;
  if (name.startsWith(typed)) return kBegins + letters;
  if (wordsBeginIn(typed, name)) return kWords + letters;
  return (name.contains(typed) ? kContains : 0) + letters;
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
    constexpr int kOfMenu = 500;
    std::optional<int> score = fuzzyScore(typed, name);
    if (const auto with_menu = fuzzyScore(typed, entry.menu + QLatin1Char(' ') + name))
      score = std::max(score.value_or(*with_menu - kOfMenu), *with_menu - kOfMenu);
    // Manuals and colleagues may say it in English.
    for (const QString& english : englishNames(entry)) {
      if (const auto in_english = fuzzyScore(typed, english))
        score = std::max(score.value_or(*in_english), *in_english);
    }
    // What was typed comes first also where it cannot be done now: Enter does nothing else then.
    const int demoted = typed.isEmpty() && !entry.action->isEnabled() ? 1000 : 0;
    if (score) hits.push_back({*score - demoted, &entry, 0});
  }
  found_.clear();
  qsizetype more = 0;
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
    if (findings.size() > kMostFound) {
      more = qsizetype(findings.size() - kMostFound);
      findings.resize(kMostFound);
    }
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
  if (more > 0) {
    auto* const item = new QListWidgetItem(
        no_icon,
        sentences::counted(
            tr("%1 more are not listed: type more of the name", nullptr, sentences::formOf(more)), more),
        list_);
    item->setFlags(Qt::NoItemFlags);
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

}  // namespace mapwright::ui

#include "moc_command_palette.cpp"
