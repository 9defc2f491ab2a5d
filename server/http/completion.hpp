#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/associated_executor.hpp>
#include <boost/beast/core/error.hpp>
#include <cstddef>
#include <memory>

namespace floeplan::http {

/// A completion handler of a read or write operation, independent of its type. Sockets and TLS are thus
/// compiled for only one type of handler, not again for each of Beast's composed operations.
/// Threads  runs on the handler's executor
/// Threads  runs on the executor that the handler was given for
class Completion {
 public:
  using executor_type = boost::asio::any_io_executor;

  template <class Handler>
  Completion(Handler handler, const executor_type& otherwise)
      : executor_{boost::asio::get_associated_executor(handler, otherwise)},
        handler_{std::make_unique<Held<Handler>>(std::move(handler))} {}

  [[nodiscard]] executor_type get_executor() const noexcept { return executor_; }

  void operator()(boost::beast::error_code error, std::size_t bytes) {
    // the call may destroy the object that contains this
    const std::unique_ptr<Base> handler = std::move(handler_);
    handler->call(error, bytes);
  }

 private:
  struct Base {
    Base() = default;
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    virtual ~Base() = default;
    virtual void call(boost::beast::error_code error, std::size_t bytes) = 0;
  };
  template <class Handler>
  struct Held final : Base {
    explicit Held(Handler&& handler) : handler_{std::move(handler)} {}
    void call(boost::beast::error_code error, std::size_t bytes) override {
      Handler handler = std::move(handler_);
      std::move(handler)(error, bytes);
    }
    Handler handler_;
  };

  executor_type executor_;
  std::unique_ptr<Base> handler_;
};

}  // namespace floeplan::http
