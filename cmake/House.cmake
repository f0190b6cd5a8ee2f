# SPDX-License-Identifier: Apache-2.0
# The arrows of the house: who may include whom, floor by floor, each room after those it stands on. A line is
# tp_may(room  rooms-it-may-include...  USES outside-libraries...); Rooms.cmake enforces it.
include(${CMAKE_CURRENT_LIST_DIR}/Rooms.cmake)

# core: what the project exists for
tp_may(tp_base)
tp_may(tp_version)
tp_may(tp_files        tp_base)
tp_may(tp_packing      tp_base  USES PkgConfig::zlib PkgConfig::archive)
tp_may(tp_libraries)
tp_may(tp_processes   tp_base  USES PkgConfig::seccomp Threads::Threads)
tp_may(tp_geometry     tp_base  USES glm::glm)
tp_may(tp_guidance     tp_base tp_geometry)
tp_may(tp_friction     tp_base tp_geometry tp_guidance)
tp_may(tp_svg          tp_base tp_files tp_geometry tp_guidance  USES PkgConfig::pugixml PkgConfig::2geom)
tp_may(tp_servo        tp_base tp_geometry tp_guidance  USES Threads::Threads)
tp_may(tp_touch        tp_base tp_geometry tp_guidance tp_friction tp_servo  USES Threads::Threads)
tp_may(tp_experiment   tp_base)
tp_may(tp_trials      tp_base tp_geometry tp_guidance tp_experiment)
tp_may(tp_participant tp_base tp_geometry)
tp_may(tp_study_folder tp_base tp_files tp_packing tp_experiment)
tp_may(tp_statistics   tp_base  USES Boost::headers)
tp_may(tp_study        tp_base tp_geometry tp_guidance tp_servo)
tp_may(tp_aiming       tp_geometry)
tp_may(tp_handheld     tp_base tp_geometry tp_aiming)
set(core tp_base tp_files tp_geometry tp_guidance tp_friction tp_touch tp_servo tp_svg tp_study)

# device: what pulls the finger
tp_may(tp_pad_protocol) # nothing at all: it runs on a microcontroller
tp_may(tp_pad_firmware   tp_pad_protocol)
tp_may(tp_haply_protocol)
tp_may(tp_force_guard    tp_haply_protocol) # a small process that starts at once
tp_may(tp_device         ${core} tp_processes tp_pad_protocol tp_pad_firmware tp_haply_protocol
                         USES PkgConfig::hidapi PkgConfig::libusb Threads::Threads)

# faces: from a photograph to contours, by the way that it goes; other rooms include decode, base and extract
tp_may(tp_exiv2        tp_base tp_files tp_processes  USES PkgConfig::exiv2)
tp_may(tp_decode       tp_base tp_files tp_libraries tp_processes tp_exiv2
                       USES PkgConfig::exiv2 PkgConfig::turbojpeg PkgConfig::png opencv_core opencv_imgproc) # never the nets
tp_may(tp_face_base    tp_geometry  USES opencv_core opencv_imgproc)
tp_may(tp_models       USES opencv_core opencv_dnn)
tp_may(tp_detect       tp_geometry tp_face_base tp_models  USES opencv_core opencv_imgproc opencv_dnn)
tp_may(tp_pieces       tp_geometry tp_face_base)
tp_may(tp_edges        tp_geometry tp_face_base tp_pieces  USES opencv_core opencv_imgproc)
tp_may(tp_contours     tp_geometry tp_face_base tp_models tp_pieces tp_edges  USES opencv_core opencv_imgproc opencv_dnn)
tp_may(tp_judge        tp_geometry tp_face_base tp_edges tp_contours  USES opencv_core opencv_imgproc)
tp_may(tp_identity    tp_base tp_geometry tp_decode tp_face_base tp_models tp_contours
                       USES opencv_core opencv_imgproc opencv_dnn)
set(of_faces tp_decode tp_face_base tp_models tp_detect tp_contours tp_edges tp_pieces tp_judge)
tp_may(tp_extract      tp_base tp_geometry ${of_faces}  USES opencv_core Threads::Threads)
tp_may(tp_evaluation   tp_base tp_files tp_geometry ${of_faces} tp_extract  USES opencv_core opencv_imgproc PkgConfig::turbojpeg)

# audio: what is heard and recorded
tp_may(tp_speech       tp_base  USES Qt6::Core Qt6::TextToSpeech)
tp_may(tp_sentences    USES Qt6::Core)
tp_may(tp_recordings   tp_base tp_files  USES PkgConfig::sndfile PkgConfig::ebur128)
tp_may(tp_video        tp_base tp_files tp_libraries tp_processes tp_recordings)
tp_may(tp_sound        tp_base tp_files tp_sentences tp_recordings  USES Qt6::Core Qt6::Multimedia PkgConfig::soundtouch)
tp_may(tp_guide        tp_base tp_sound  USES Qt6::Core)

set(below_app ${core} tp_device tp_decode tp_face_base tp_extract tp_speech tp_sentences tp_recordings tp_sound)

tp_may(tp_program_version tp_version
                       USES Qt6::Core opencv_core PkgConfig::exiv2 PkgConfig::sndfile PkgConfig::archive PkgConfig::louis PkgConfig::libusb)

tp_may(tp_seen         tp_geometry) # plain data of app/photo, which the index keeps

# app/album: photographs, people and recordings as files, and their index
tp_may(tp_metadata     tp_base tp_files tp_recordings tp_exiv2  USES PkgConfig::pugixml)
tp_may(tp_index        tp_base tp_files tp_geometry tp_recordings tp_metadata tp_seen  USES Qt6::Core Qt6::Sql)
tp_may(tp_keeper       tp_base tp_files tp_recordings tp_video tp_metadata tp_index  USES Qt6::Core PkgConfig::archive)
tp_may(tp_check        tp_base tp_files tp_recordings tp_metadata tp_keeper)

# app/photo: from a photograph to something said, shown, felt or printed
tp_may(tp_sight        tp_base tp_geometry tp_study tp_decode tp_face_base tp_extract tp_identity tp_seen
                       USES opencv_core opencv_imgproc)
tp_may(tp_towns        tp_base)
tp_may(tp_scene        tp_base tp_files tp_geometry tp_guidance tp_svg tp_face_base)
tp_may(tp_study_faces  tp_base tp_files tp_geometry tp_guidance tp_svg tp_experiment tp_trials tp_decode tp_face_base tp_extract tp_scene
                       USES opencv_core)
tp_may(tp_people       tp_base tp_geometry tp_face_base tp_metadata)
tp_may(tp_words        tp_geometry tp_metadata tp_people tp_seen tp_towns  USES Qt6::Core)
tp_may(tp_picture      ${below_app}  USES Qt6::Gui)
tp_may(tp_tactile      ${below_app} tp_scene  USES Qt6::Gui PkgConfig::pugixml PkgConfig::louis)

# app/capture: a camera as the program sees it
tp_may(tp_frames       tp_base tp_files tp_geometry tp_aiming tp_handheld tp_decode tp_video  USES opencv_core opencv_imgproc Threads::Threads)
tp_may(tp_seeing       tp_base tp_geometry tp_aiming tp_face_base tp_identity tp_extract tp_frames  USES opencv_core opencv_imgproc Threads::Threads)
tp_may(tp_shutter      tp_base tp_files tp_geometry tp_aiming tp_exiv2 tp_face_base tp_extract tp_recordings tp_metadata
                       tp_keeper tp_seen tp_sight tp_words tp_frames tp_seeing
                       USES opencv_core opencv_imgproc PkgConfig::exiv2 PkgConfig::turbojpeg Qt6::Core)
tp_may(tp_camera       tp_base tp_files tp_geometry tp_aiming tp_handheld tp_decode tp_frames
                       USES Qt6::Multimedia opencv_core opencv_imgproc)

# app/parts: what pages share
tp_may(tp_controls     ${below_app}  USES Qt6::Quick Qt6::QuickControls2 Qt6::DBus)
tp_may(tp_narration    tp_base tp_speech tp_controls  USES Qt6::Core)
tp_may(tp_work         USES Qt6::Core)
tp_may(tp_preferences  tp_base tp_files tp_sentences  USES Qt6::Core)
tp_may(tp_folders      ${below_app} tp_controls tp_narration  USES Qt6::Quick)
tp_may(tp_feedbackd    tp_base tp_touch tp_device  USES Qt6::Core Qt6::DBus)
tp_may(tp_devices      tp_base tp_files tp_geometry tp_guidance tp_friction tp_touch tp_servo tp_device tp_sentences tp_feedbackd  USES Qt6::Core)
tp_may(tp_finger      tp_base tp_geometry tp_guidance tp_friction tp_touch tp_servo tp_device tp_sentences tp_devices  USES Qt6::Core)
# … among them the rooms of app/album that are at work as long as the program is
tp_may(tp_open_album   tp_base tp_files tp_sentences tp_recordings tp_metadata tp_index tp_keeper tp_preferences  USES Qt6::Core)
tp_may(tp_grouping     tp_base tp_geometry tp_metadata tp_index tp_identity tp_people tp_open_album  USES Qt6::Core)
tp_may(tp_looking      tp_base tp_metadata tp_index tp_open_album tp_seen tp_sight tp_words  USES Qt6::Core)

# app/figures: measurements that end in tables and plots
tp_may(tp_report       ${below_app} tp_aiming tp_handheld  USES Qt6::Gui Qt6::Svg)
tp_may(tp_simulated    ${below_app} tp_pad_firmware tp_experiment tp_study_folder tp_trials tp_participant tp_report  USES Threads::Threads)
tp_may(tp_study_report tp_base tp_files tp_geometry tp_experiment tp_study_folder tp_statistics tp_report  USES Qt6::Core Qt6::Gui)
tp_may(tp_bench        tp_base tp_geometry tp_guidance tp_decode tp_face_base tp_identity tp_extract tp_evaluation
                       tp_picture tp_report
                       USES Boost::headers nanoflann::nanoflann)

# app/pages: what a person meets; no page knows another
set(for_pages ${below_app} tp_guide tp_metadata tp_index tp_keeper tp_open_album tp_people tp_seen tp_words tp_scene
              tp_picture tp_tactile tp_controls tp_narration tp_work tp_preferences tp_folders tp_devices tp_finger)
set(pages tp_start tp_browse tp_explore tp_settings tp_lab)
foreach(page IN LISTS pages)
  tp_may(${page}       ${for_pages}  USES Qt6::Quick)
endforeach()
tp_may(tp_care         ${for_pages} tp_identity tp_grouping  USES Qt6::Quick)
tp_may(tp_capture      ${for_pages} tp_aiming tp_handheld tp_frames tp_camera tp_seeing tp_shutter  USES Qt6::Quick)
tp_may(tp_study_page   ${for_pages} tp_experiment tp_trials tp_study_folder tp_study_faces tp_study_report  USES Qt6::Quick)
tp_may(tp_mend         ${for_pages} tp_report  USES Qt6::Quick)
tp_may(tp_print        ${for_pages}  USES Qt6::Quick Qt6::Svg)

# the two programs
tp_may(tp_shell        ${for_pages} ${pages} tp_care tp_capture tp_study_page tp_camera tp_seeing tp_mend tp_print tp_identity tp_looking tp_grouping  USES Qt6::Quick)
tp_may(tp_cli          ${below_app} tp_metadata tp_index tp_keeper tp_check tp_people tp_seen tp_sight tp_words tp_scene tp_picture tp_tactile tp_devices tp_feedbackd
                       tp_report tp_bench tp_models tp_evaluation tp_aiming tp_handheld tp_experiment tp_study_folder tp_statistics tp_study_report tp_simulated tp_trials tp_version tp_program_version  USES Qt6::Core Qt6::Gui)
