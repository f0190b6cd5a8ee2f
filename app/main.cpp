// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/media_backend.hpp"
#include "app/capture/camera/stand_in_camera.hpp"
#include "app/pages/explore/demonstration.hpp"
#include "app/shell/end_signals.hpp"
#include "app/shell/program_window.hpp"
#include "app/version/program_version.hpp"
#include "audio/sentences/sentences.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/sound/system_loudspeaker.hpp"
#include "audio/speech/spoken_voice.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "core/version/version.hpp"
#include "device/registry.hpp"

#include <QCommandLineParser>
#include <QFile>
#include <QGuiApplication>
#include <QIcon>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

namespace {

constexpr int picture_after_ms = 3000; ///< by then faces are found and pictures painted

/// The sample that the program carries, as a file; empty where there is none.
QString sample_photo(const QTemporaryDir& folder) {
    const QString copy = folder.filePath("sample portrait.jpg");
    return QFile::copy(":/samples/portrait.jpg", copy) ? copy : QString();
}

/// Writes a picture of the window and ends the program.
void take_picture(QQuickView& window, const QString& file) {
    const bool saved = window.grabWindow().save(file);
    if (!saved)
        std::fprintf(stderr, "The picture could not be written to %s.\n", qUtf8Printable(file));
    QCoreApplication::exit(saved ? 0 : 1);
}

std::vector<tp::FoundDevice> force_devices() {
    std::vector<tp::FoundDevice> found;
    for (const tp::ListedDevice& device : tp::list_devices())
        if (!device.interface.empty()) // the simulated one is always there
            found.push_back(
                {tp::in_persons_language(device.about), QString::fromStdString(device.serial_number)});
    return found;
}

/// "1280x800"
std::optional<QSize> size_named(const QString& text) {
    const QStringList parts = text.split('x');
    const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
    return size.width() > 0 && size.height() > 0 ? std::optional(size) : std::nullopt;
}

int refuse(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    return 2;
}

/// Answered without a display, so that it can be asked over a plain line too.
bool asks_for_version(std::span<char* const> words) {
    return std::any_of(words.begin(), words.end(), [](const char* word) {
        return std::strcmp(word, "--version") == 0 || std::strcmp(word, "-v") == 0;
    });
}

} // namespace

int main(int argc, char** argv) {
    if (asks_for_version({argv, static_cast<std::size_t>(argc)})) {
        std::fputs(tp::program_version("touchphoto").c_str(), stdout);
        return 0;
    }
    tp::use_steady_media_backend();
    QGuiApplication app(argc, argv);
    QCoreApplication::setApplicationName("touchphoto");
    QCoreApplication::setApplicationVersion(tp::version_number());
    QGuiApplication::setDesktopFileName("org.touchphoto.TouchPhoto"); // whose name and icon its window has
    QGuiApplication::setWindowIcon(QIcon::fromTheme("org.touchphoto.TouchPhoto"));
    const tp::EndSignals end;

    QCommandLineParser options;
    options.setApplicationDescription("Feel the face in a photograph.");
    options.addHelpOption();
    options.addVersionOption();
    options.addPositionalArgument(
        "photo",
        "A photograph to feel at once, or a .touchphoto bundle to import; without one the start page opens.",
        "[photo]");
    const QCommandLineOption voice_option(
        "voice", "Whether the program speaks: on, off, or as it was chosen (default).", "on|off");
    const QCommandLineOption page_option(
        "page",
        "The page to begin with: start, browse, explore, care, capture, mend, print, settings, lab, study.",
        "name");
    const QCommandLineOption picture_option("screenshot", "Writes a picture of the page to <file> and ends.",
                                            "file");
    const QCommandLineOption size_option("size", "The window's size in pixels, such as 1280x800.", "WxH");
    const QCommandLineOption with_option(
        "with", "Adds features to eyes, lips and outline: brows, nose, irises.", "list");
    const QCommandLineOption camera_option(
        "camera",
        "Takes photographs with another camera: \"simulated:PHOTO\" looks "
        "into a photograph and is moved by keys, "
        "\"folder:DIR\" gives the pictures of a folder, \"video:FILE\" those of "
        "a video, over and over.",
        "camera");
    const QCommandLineOption touch_option("touch",
                                          "Ticks under the finger by one more output: \"simulated:FILE\" is "
                                          "plugged in while that file is there, "
                                          "and writes each tick to its end.",
                                          "output");
    options.addOptions(
        {voice_option, page_option, with_option, picture_option, size_option, camera_option, touch_option});
    options.process(app);
    const QString voice_wish = options.value(voice_option);
    if (options.isSet(voice_option) && voice_wish != "on" && voice_wish != "off")
        return refuse("--voice is \"on\" or \"off\".");
    const auto extras = tp::extra_features_named(options.value(with_option).toStdString());
    if (!extras)
        return refuse(extras.error());
    const std::optional<QSize> size = size_named(options.value(size_option));
    if (options.isSet(size_option) && !size)
        return refuse("--size is a width and a height in pixels, such as 1280x800.");

    const std::string camera = options.value(camera_option).toStdString();
    if (options.isSet(camera_option) && (camera.empty() || !tp::camera_named(camera)))
        return refuse("--camera is \"simulated:\" with a photograph, \"folder:\" with a folder, or "
                      "\"video:\" with a video.");

    const auto motor_file = tp::motor_file_named(options.value(touch_option).toStdString());
    if (options.isSet(touch_option) && !motor_file)
        return refuse("--touch is \"simulated:\" with a file, such as simulated:/tmp/motor.");

    tp::decode_in_helpers(&tp::touchphoto_decoders());
    tp::SpokenVoice voice;
    tp::ProgramParts parts{voice,
                           [] { return std::make_unique<tp::SystemLoudspeaker>(); },
                           tp::system_microphone,
                           tp::Preferences::usual_file(),
                           tp::OpenAlbum::usual_cache(),
                           tp::PrintSession::usual_folder(),
                           {},
                           force_devices};
    parts.explore.extras = *extras;
    parts.explore.devices =
        tp::DeviceAccess::of_this_computer(tp::Preferences::usual_file().parent_path() / "calibrations.txt");
    const tp::SurfaceSize surface = parts.explore.surface;
    parts.make_touch = [surface, motor_file](const std::shared_ptr<tp::TickListener>& listener) {
        const auto access = tp::TouchAccess::of_this_computer(surface.width_mm, surface.height_mm, listener);
        return motor_file ? access.with_motor_file(*motor_file) : access;
    };
    parts.make_camera = [camera] { return tp::camera_named(camera); };
    const bool picture = options.isSet(picture_option);
    if (options.isSet(voice_option) || picture)
        parts.by = voice_wish == "on" && !picture ? tp::Narrator::By::voice : tp::Narrator::By::screen_reader;
    tp::Program program(std::move(parts));

    const QTemporaryDir folder;
    const QString page = options.value(page_option);
    QString photo = options.positionalArguments().value(0);
    const tp::Choices& choices = program.preferences().choices();
    if (photo.isEmpty() && page == "explore" && choices.last_photo.isEmpty() && choices.folders.isEmpty())
        photo = sample_photo(folder);
    program.begin(photo);
    tp::ProgramWindow window(program);
    if (window.status() == QQuickView::Error)
        return 1; // Qt has said why
    if (size)
        window.resize(*size);
    else if (!picture)
        window.fit_to_screen();
    QObject::connect(&end, &tp::EndSignals::asked, &window, [&program] {
        program.keep_all();
        QCoreApplication::quit();
    });
    window.show();
    if (photo.isEmpty() && !page.isEmpty())
        program.open_page(page);

    std::optional<tp::Demonstration> demonstration;
    if (picture && !photo.isEmpty())
        QObject::connect(&demonstration.emplace(program.explore()), &tp::Demonstration::finished, &window,
                         [&] { take_picture(window, options.value(picture_option)); });
    else if (picture)
        QTimer::singleShot(picture_after_ms, &window,
                           [&] { take_picture(window, options.value(picture_option)); });
    return QGuiApplication::exec();
}
