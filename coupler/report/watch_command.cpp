#include "coupler/report/watch_command.hpp"

#include <fmt/ranges.h>
#include <httplib.h>

#include <charconv>
#include <mutex>
#include <random>
#include <thread>

#include "common/error.hpp"
#include "coupler/interruption.hpp"
#include "coupler/report/page.hpp"
#include "coupler/report/run_document.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* this_machine = "127.0.0.1";

/// 128 random bits of the system, in hexadecimal digits.
std::string secret() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

std::size_t number(const std::string& text) {
  std::size_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);  // other text counts as 0
  return value;
}

/// The watched runs; calls are serialised, because the HDF5 library supports one thread at a time.
class WatchedRuns {
 public:
  explicit WatchedRuns(const WatchOptions& options) {
    std::vector<std::string> wrong;
    const DocumentOptions document{
        .case_folder = "", .megabytes = options.megabytes / static_cast<double>(options.results.size())};
    for (const std::string& results : options.results) {
      try {
        Results::file_at(results);
        read_patiently([&] { runs_.emplace_back(results, document); });
      } catch (const Error& error) {
        wrong.push_back(error.what());
      }
    }
    require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  }

  std::size_t size() const { return runs_.size(); }

  std::string whole_page() {
    const std::lock_guard turn(mutex_);
    Json runs = Json::array();
    for (RunDocument& run : runs_) read_patiently([&] { runs.push_back(run.read()); });
    return page(page_document("watch", std::move(runs)));
  }

  /// The data of a run with its frames from `frames` on; empty if the page has all of it.
  std::string news(std::size_t run, std::size_t frames, std::size_t windows, const std::string& state) {
    const std::lock_guard turn(mutex_);
    std::string text;
    read_patiently([&] {
      text.clear();
      if (runs_[run].has_news(frames, windows, state))
        text = runs_[run].read(frames).dump(-1, ' ', false, Json::error_handler_t::replace);
    });
    return text;
  }

 private:
  std::mutex mutex_;
  std::vector<RunDocument> runs_;
};

void answer(httplib::Response& response, const std::function<std::string()>& text, const char* type) {
  try {
    const std::string body = text();
    response.set_header("Cache-Control", "no-store");
    if (body.empty())
      response.status = 204;
    else
      response.set_content(body, type);
  } catch (const std::exception& error) {
    response.status = 500;
    response.set_content(error.what(), "text/plain");
  }
}

/// Answers requests whose path begins with the secret word; others get "not found".
void lay_out(httplib::Server& server, const std::string& word, WatchedRuns& runs) {
  server.Get("/" + word + "/", [&runs](const httplib::Request&, httplib::Response& response) {
    answer(
        response, [&] { return runs.whole_page(); }, "text/html; charset=utf-8");
  });
  server.Get(
      "/" + word + R"(/run/(\d+))", [&runs](const httplib::Request& request, httplib::Response& response) {
        const std::size_t run = number(request.matches[1]);
        if (run >= runs.size()) {
          response.status = 404;
          return;
        }
        answer(
            response,
            [&] {
              return runs.news(run, number(request.get_param_value("frames")),
                               number(request.get_param_value("windows")), request.get_param_value("state"));
            },
            "application/json");
      });
}

}  // namespace

int watch_command(const WatchOptions& options) {
  WatchedRuns runs(options);
  runs.whole_page();  // report errors now, not later in the browser
  const std::string word = secret();
  httplib::Server server;
  lay_out(server, word, runs);
  const int port = options.port > 0 ? options.port : server.bind_to_any_port(this_machine);
  require(
      options.port > 0 ? server.bind_to_port(this_machine, port) : port > 0,
      "--port {}: cannot be used on {}: it is in use, or below 1024; without --port a free port is chosen",
      options.port, this_machine);
  note_interruptions();
  std::thread serving([&] { server.listen_after_bind(); });
  while (!server.is_running())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // otherwise a stop() at this moment is lost
  say("watch: http://{}:{}/{}/\nopen it in a browser on this machine; Ctrl-C stops the page, not the run\n",
      this_machine, port, word);
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  server.stop();
  serving.join();
  return 0;
}

}  // namespace cosurge
