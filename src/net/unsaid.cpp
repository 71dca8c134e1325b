#include "net/unsaid.h"

#include <algorithm>
#include <cctype>

#include <QJsonArray>
#include <QJsonDocument>

#include "net/plain_sentences.h"

namespace mapwright::net {
namespace {

constexpr std::size_t kMacDigits = 65;  // a SHA-512 has 128, and may be cut off
constexpr const char* kInstead = "***";

void replaceAll(std::string& words, const std::string& form) {
  for (auto at = words.find(form); at != std::string::npos; at = words.find(form, at + 3))
    words.replace(at, form.size(), kInstead);
}

/// As JSON has it between its quotes.
QByteArray inJson(const QByteArray& secret) {
  const QByteArray json = QJsonDocument(QJsonArray{QString::fromUtf8(secret)}).toJson(QJsonDocument::Compact);
  return json.mid(2, json.size() - 4);
}

void replaceMacs(std::string& words) {
  const auto isHex = [](unsigned char c) { return std::isxdigit(c) != 0; };
  for (std::size_t at = 0; at + kMacDigits <= words.size();) {
    const auto from = words.begin() + std::ptrdiff_t(at);
    const auto end = std::find_if_not(from, words.end(), isHex);
    const auto digits = std::size_t(end - from);
    if (digits >= kMacDigits) {
      words.replace(at, digits, kInstead);
      at += 3;
    } else {
      at += digits + 1;
    }
  }
}

}  // namespace

Unsaid::Unsaid(const QByteArray& secret, std::size_t shortest) {
  if (secret.isEmpty() || std::size_t(secret.size()) < shortest) return;
  const QByteArray quoted = inJson(secret);
  for (const QByteArray& form :
       {secret, secret.toPercentEncoding(), secret.toBase64(),
        secret.toBase64(QByteArray::OmitTrailingEquals), secret.toHex(), quoted,
        QByteArray(quoted).replace('/', "\\/"), net::plainText(QString::fromUtf8(secret)).toUtf8()}) {
    if (!form.isEmpty() && std::size_t(form.size()) >= shortest) forms_.push_back(form.toStdString());
  }
  // One form may begin with another.
  std::sort(forms_.begin(), forms_.end(),
            [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
}

void Unsaid::hideIn(std::string& words) const {
  for (const std::string& form : forms_) replaceAll(words, form);
  replaceMacs(words);
}

void Unsaid::hideIn(QString& words) const {
  std::string text = words.toStdString();
  hideIn(text);
  words = QString::fromStdString(text);
}

void Unsaid::hideIn(QByteArray& utf8) const {
  std::string text = utf8.toStdString();
  hideIn(text);
  if (text != utf8.toStdString()) utf8 = QByteArray::fromStdString(text);
}

}  // namespace mapwright::net
