// SPDX-License-Identifier: Apache-2.0
#include "sim/report/page.h"

#include <fmt/format.h>

#include "sim/report/html.h"
#include "sim/report/style.h"

namespace shading::report {

Page::Page(std::string title, std::vector<std::string> facts)
    : title_(std::move(title)), facts_(std::move(facts)) {}

void Page::Section(std::string_view heading) {
  contents_.emplace_back(heading);
  body_ += fmt::format("<h2 id=\"s{}\">{}</h2>\n", contents_.size(), EscapeHtml(heading));
}

void Page::Subsection(std::string_view heading) {
  body_ += fmt::format("<h3>{}</h3>\n", EscapeHtml(heading));
}

void Page::Text(std::string_view text) { body_ += fmt::format("<p>{}</p>\n", EscapeHtml(text)); }

void Page::List(const std::vector<std::string>& items) {
  body_ += "<ul>";
  for (const std::string& item : items) body_ += fmt::format("<li>{}</li>\n", EscapeHtml(item));
  body_ += "</ul>\n";
}

void Page::Command(std::string_view command) {
  body_ += fmt::format("<pre>{}</pre>\n", EscapeHtml(command));
}

void Page::Markup(std::string_view html) { body_ += html; }

void Page::Figure(const std::vector<std::string>& pictures, std::string_view caption,
                  std::string_view command) {
  body_ += "<figure><div class=\"row\">";
  for (const std::string& picture : pictures) body_ += fmt::format("<div>{}</div>", picture);
  body_ += fmt::format("</div><figcaption>{}", EscapeHtml(caption));
  if (!command.empty()) body_ += fmt::format("<code>{}</code>", EscapeHtml(command));
  body_ += "</figcaption></figure>\n";
}

std::string Page::Html() const {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{0}</title>\n<style>{1}</style></head>\n<body><main>\n<h1>{0}</h1>\n",
      EscapeHtml(title_), kStyle);
  html += "<ul class=\"facts\">";
  for (const std::string& fact : facts_) html += fmt::format("<li>{}</li>", EscapeHtml(fact));
  html += "</ul>\n<nav><ol>";
  for (size_t i = 0; i < contents_.size(); ++i) {
    html += fmt::format("<li><a href=\"#s{}\">{}</a></li>", i + 1, EscapeHtml(contents_[i]));
  }
  return html + "</ol></nav>\n" + body_ +
         fmt::format("</main>\n<script>{}</script></body></html>\n", kScript);
}

}  // namespace shading::report
