#include "ui/maps/change_dialog.h"

#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include "jobs/change_map.h"
#include "sentences/failure_sentence.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::window {

ChangeDialog::ChangeDialog(ChangeQuestion question, Ask ask, QWidget* parent)
    : QDialog(parent),
      question_(std::move(question)),
      ask_(std::move(ask)),
      text_(new QLabel(this)),
      error_(new QLabel(this)),
      accept_(new QPushButton(question_.accept, this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(question_.title);
  setMinimumWidth(440);
  for (QLabel* label : {text_, error_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  text_->setText(question_.text);
  error_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  if (question_.name) {
    name_ = new QLineEdit(*question_.name, this);
    name_->setObjectName(QStringLiteral("name"));
    name_->selectAll();
    form->addRow(tr("&Name"), name_);
    connect(name_, &QLineEdit::textChanged, this, &ChangeDialog::check);
  }
  if (question_.asks_place) {
    places_ = new QComboBox(this);
    places_->setObjectName(QStringLiteral("place"));
    places_->setEditable(true);
    places_->setInsertPolicy(QComboBox::NoInsert);
    places_->setMinimumContentsLength(24);
    setPlaces({});
    form->addRow(tr("The robot stands at &waypoint"), places_);
  }
  if (!question_.typed.isEmpty()) {
    typed_ = new QLineEdit(this);
    typed_->setObjectName(QStringLiteral("typed"));
    typed_->setPlaceholderText(question_.typed);
    form->addRow(tr("&Type its name"), typed_);
    connect(typed_, &QLineEdit::textChanged, this, &ChangeDialog::check);
  }
  if (question_.ends_something) {
    giveCarefulRoles(*accept_, *cancel_);
  } else {
    giveRoles(*accept_, {cancel_});
  }
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch();
  buttons->addWidget(cancel_);
  buttons->addWidget(accept_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(10);
  column->addWidget(text_);
  if (form->rowCount() > 0) {
    column->addLayout(form);
  } else {
    delete form;
  }
  column->addWidget(error_);
  column->addLayout(buttons);
  connect(accept_, &QPushButton::clicked, this, &ChangeDialog::send);
  connect(cancel_, &QPushButton::clicked, this, &ChangeDialog::reject);
  if (QLineEdit* const field = name_ ? name_ : typed_) field->setFocus();
  check();
}

void ChangeDialog::setPlaces(const std::vector<std::string>& names) {
  if (!places_) return;
  const QString typed = place().empty() ? QString() : places_->currentText();
  places_->clear();
  places_->addItem(tr("not stated"), QString());
  for (const std::string& name : names)
    places_->addItem(words::plainName(name), QString::fromStdString(name));
  if (!typed.isEmpty()) places_->setEditText(typed);
}

/// Empty: not stated.
std::string ChangeDialog::place() const {
  const QString text = places_->currentText();
  const int chosen = places_->currentIndex();
  const int at = chosen >= 0 && places_->itemText(chosen) == text ? chosen : places_->findText(text);
  return (at >= 0 ? places_->itemData(at).toString() : text.trimmed()).toStdString();
}

QString ChangeDialog::textShown() const { return text_->text(); }
QString ChangeDialog::errorShown() const { return error_->text(); }

QString ChangeDialog::whyNot() const {
  if (name_) {
    if (QString why = jobs::whyNoMapName(name_->text()); !why.isEmpty()) return why;
    if (question_.order.change == robot::MapChange::Rename && name_->text() == *question_.name)
      return tr("It already has this name.");
  }
  if (typed_ && typed_->text() != question_.typed) return tr("Type the name of the map to delete it.");
  return {};
}

void ChangeDialog::check() {
  const QString why = whyNot();
  // The initial text is not an error yet.
  const bool touched = (name_ && name_->isModified()) || (typed_ && !typed_->text().isEmpty());
  QPalette palette = error_->palette();
  palette.setColor(QPalette::WindowText, appColors().secondary_text);
  error_->setPalette(palette);
  error_->setText(touched ? why : QString());
  accept_->setEnabled(why.isEmpty() && !waiting());
}

void ChangeDialog::send() {
  if (waiting() || !whyNot().isEmpty()) return;
  robot::MapOrder& order = question_.order;
  if (name_) order.name = name_->text().toStdString();
  if (places_) order.place = place();
  for (QWidget* field :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(typed_), static_cast<QWidget*>(places_)})
    if (field) field->setEnabled(false);
  call_.emplace();  // before the request: nothing is sent twice
  *call_ = ask_(order, [self = QPointer<ChangeDialog>(this)](const Outcome& outcome) {
    if (self) self->take(outcome);
  });
  check();
  error_->setText(tr("Waiting for the robot…"));
}

void ChangeDialog::take(const Outcome& outcome) {
  call_.reset();
  for (QWidget* field :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(typed_), static_cast<QWidget*>(places_)})
    if (field) field->setEnabled(true);
  check();
  if (outcome) {
    QString said = jobs::oddity(question_.order, *outcome);
    const bool as_asked = said.isEmpty();
    if (as_asked) said = question_.done;
    if (as_asked && said.contains(QLatin1String("%1")))
      said = said.arg(words::plainName(outcome->name).left(80));
    Q_EMIT done(*outcome, said, as_asked);
    accept();
    return;
  }
  QPalette palette = error_->palette();
  palette.setColor(QPalette::WindowText, appColors().error_text);
  error_->setPalette(palette);
  error_->setText(QString::fromStdString(sentences::sentenceOf(outcome.error())));
}

void ChangeDialog::reject() {
  // The robot reports the result: the dialog closes then.
  if (waiting()) {
    call_->cancel();
    error_->setText(tr("Cancelling: checking whether the change took effect…"));
    return;
  }
  QDialog::reject();
}

}  // namespace mapwright::window

#include "moc_change_dialog.cpp"
