// The manual: its pages, a search through all of them, back and forward.
#pragma once

#include <vector>

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QTextBrowser;

namespace mapwright::ui {

class ManualWindow : public QDialog {
  Q_OBJECT
 public:
  explicit ManualWindow(QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Passage {  // a paragraph, or a row of a table
    int page = 0, position = 0;
    QString heading, text;
  };
  void readAll();
  void listPages(const QUrl& open);
  void listHits();
  void open(const QListWidgetItem* item);
  void mark();

  std::vector<QString> titles_;    // of pages()
  std::vector<Passage> passages_;  // read when the first search begins
  QLineEdit* search_;
  QLabel* said_;
  QListWidget* list_;
  QTextBrowser* page_;
};

}  // namespace mapwright::ui
