// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/wide_text.hpp"
#include "core/processes/child_process.hpp"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

namespace tp {
namespace {

using windows::Handle;

constexpr int first_given = 3; ///< after the standard streams
constexpr const char* given_setting = "TOUCHPHOTO_GIVEN";

HANDLE handle_of(DescriptorNumber number) { return reinterpret_cast<HANDLE>(number); }

/// Another handle of the same, which a process that is given it inherits.
Handle inheritable(HANDLE own) {
    HANDLE made = nullptr;
    DuplicateHandle(GetCurrentProcess(), own, GetCurrentProcess(), &made, 0, TRUE, DUPLICATE_SAME_ACCESS);
    return Handle(made);
}

/// Reads nothing and takes everything.
Handle nothing() {
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    return Handle(CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                              &inherited, OPEN_EXISTING, 0, nullptr));
}

/// One of its standard streams.
Handle stream(DWORD which, Streams streams) {
    const HANDLE own = streams == Streams::ours ? GetStdHandle(which) : nullptr;
    Handle another = own != nullptr && own != INVALID_HANDLE_VALUE ? inheritable(own) : Handle();
    return another ? std::move(another) : nothing();
}

/// A word as the libraries of C take a command line apart: backslashes count only before a quotation mark.
std::wstring quoted(const std::wstring& word) {
    std::wstring line = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t letter : word) {
        if (letter == L'"')
            line.append(backslashes + 1, L'\\');
        backslashes = letter == L'\\' ? backslashes + 1 : 0;
        line += letter;
    }
    return line.append(backslashes, L'\\') + L'"';
}

struct BeforeInAnyCase {
    bool operator()(const std::wstring& one, const std::wstring& other) const {
        return CompareStringOrdinal(one.c_str(), -1, other.c_str(), -1, TRUE) == CSTR_LESS_THAN;
    }
};

/// This process's environment with these before it, by name, as Windows wants it.
std::wstring environment_with(const std::vector<std::string>& settings) {
    std::map<std::wstring, std::wstring, BeforeInAnyCase> lines; // of one name the first
    const auto add = [&lines](std::wstring line) {
        std::wstring name = line.substr(0, line.find(L'=', 1)); // a drive's folder is called =C:
        lines.emplace(std::move(name), std::move(line));
    };
    for (const std::string& setting : settings)
        add(windows::wide(setting));
    wchar_t* const own = GetEnvironmentStringsW();
    for (const wchar_t* line = own; line != nullptr && *line != L'\0';
         line += std::wstring_view(line).size() + 1)
        add(line);
    FreeEnvironmentStringsW(own);
    std::wstring block;
    for (const auto& [name, line] : lines)
        block.append(line).push_back(L'\0');
    return block + L'\0';
}

/// The process, which inherits the handles; the first three are its standard streams.
Handle created(const std::filesystem::path& program, std::wstring line, std::wstring environment,
               std::vector<HANDLE> inherited) {
    SIZE_T size = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    std::vector<std::uint8_t> room(size);
    STARTUPINFOEXW start{};
    start.StartupInfo.cb = sizeof start;
    start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    start.StartupInfo.hStdInput = inherited[0];
    start.StartupInfo.hStdOutput = inherited[1];
    start.StartupInfo.hStdError = inherited[2];
    start.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room.data());
    if (InitializeProcThreadAttributeList(start.lpAttributeList, 1, 0, &size) == 0)
        return {};
    PROCESS_INFORMATION made{};
    const bool started = UpdateProcThreadAttribute(
                             start.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, inherited.data(),
                             inherited.size() * sizeof(HANDLE), nullptr, nullptr) != 0 &&
                         CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE,
                                        EXTENDED_STARTUPINFO_PRESENT | CREATE_UNICODE_ENVIRONMENT |
                                            CREATE_NEW_PROCESS_GROUP | CREATE_NO_WINDOW,
                                        environment.data(), nullptr, &start.StartupInfo, &made) != 0;
    DeleteProcThreadAttributeList(start.lpAttributeList);
    const Handle thread(made.hThread);
    return Handle(started ? made.hProcess : nullptr);
}

std::chrono::nanoseconds time_of(const FILETIME& time) { // which counts 100 ns
    const auto ticks = (std::uint64_t{time.dwHighDateTime} << 32) | time.dwLowDateTime;
    return std::chrono::nanoseconds(static_cast<std::int64_t>(ticks * 100));
}

} // namespace

std::optional<ChildProcess> ChildProcess::start(const std::filesystem::path& program,
                                                const std::vector<std::string>& words,
                                                std::span<const DescriptorNumber> given, Streams streams,
                                                const std::vector<std::string>& settings) {
    std::vector<Handle> its;
    for (const DWORD which : {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE, STD_ERROR_HANDLE})
        its.push_back(stream(which, streams));
    std::string numbers = std::string(given_setting) + '=';
    for (const DescriptorNumber number : given) {
        its.push_back(inheritable(handle_of(number)));
        numbers += std::to_string(reinterpret_cast<DescriptorNumber>(its.back().get())) + ' ';
    }
    std::vector<HANDLE> inherited;
    for (const Handle& one : its) {
        if (!one)
            return std::nullopt;
        inherited.push_back(one.get());
    }
    std::wstring line = quoted(program.wstring());
    for (const std::string& word : words)
        line += L' ' + quoted(windows::wide(word));
    std::vector<std::string> all_settings{numbers};
    all_settings.insert(all_settings.end(), settings.begin(), settings.end());
    Handle process = created(program, std::move(line), environment_with(all_settings), std::move(inherited));
    return process ? std::optional(ChildProcess(reinterpret_cast<DescriptorNumber>(process.release())))
                   : std::nullopt;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : process_(std::exchange(other.process_, 0)) {}

ChildProcess::~ChildProcess() {
    const Handle process(handle_of(process_));
    if (process)
        WaitForSingleObject(process.get(), INFINITE);
}

void ChildProcess::kill() noexcept {
    if (process_ != 0)
        TerminateProcess(handle_of(process_), 1);
}

std::optional<std::chrono::nanoseconds> ChildProcess::computed() const {
    FILETIME begun{}, ended{}, in_kernel{}, computing{};
    if (WaitForSingleObject(handle_of(process_), 0) != WAIT_TIMEOUT ||
        GetProcessTimes(handle_of(process_), &begun, &ended, &in_kernel, &computing) == 0)
        return std::nullopt;
    return time_of(in_kernel) + time_of(computing);
}

Descriptor given_descriptor(int number) {
    const char* const numbers = std::getenv(given_setting);
    std::istringstream in(numbers == nullptr ? "" : numbers);
    DescriptorNumber given = -1;
    for (int at = first_given; at <= number; ++at)
        if (!(in >> given))
            return Descriptor();
    return Descriptor(given);
}

} // namespace tp
