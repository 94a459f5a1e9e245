; Installs Feedscope for one user, without administrator. packaging/windows/build gives VERSION, FROM and OUT, and WINDOW where
; the program has a window: an entry of its own in the start menu, and sessions that open in it. NC programs stay with the
; program that the user opens them with.
Target amd64-unicode
ManifestDPIAware true
SetCompressor /SOLID lzma
RequestExecutionLevel user
!ifdef WINDOW
Name "Feedscope"
!else
Name "Feedscope command line"
!endif
OutFile "${OUT}"
InstallDir "$LOCALAPPDATA\Programs\Feedscope"
InstallDirRegKey HKCU "Software\Feedscope" "Folder"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\Feedscope"
!include "FileFunc.nsh"
!include "LogicLib.nsh"

!ifdef WINDOW
Page components
!endif
Page directory
Page instfiles
UninstPage uninstConfirm
UninstPage instfiles

Section "Feedscope"
  SectionIn RO
  SetOutPath "$INSTDIR"
  File /r "${FROM}/*"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  ; A console in which the command is found; the user's own PATH stays as it is.
  CreateShortCut "$SMPROGRAMS\Feedscope command line.lnk" "$SYSDIR\cmd.exe" '/k "set PATH=$INSTDIR\bin;%PATH%"'
  WriteRegStr HKCU "Software\Feedscope" "Folder" "$INSTDIR"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "$(^Name)"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${UNINSTALL}" "Publisher" "Feedscope developers"
  WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
  WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
  ${GetSize} "$INSTDIR" "/S=0K" $0 $1 $2
  WriteRegDWORD HKCU "${UNINSTALL}" "EstimatedSize" $0
!ifdef WINDOW
  CreateShortCut "$SMPROGRAMS\Feedscope.lnk" "$INSTDIR\bin\feedscope.exe"
!endif
SectionEnd

!ifdef WINDOW
Section "Open sessions (.feedscope) by a double click"
  WriteRegStr HKCU "Software\Classes\.feedscope" "" "Feedscope.Session"
  WriteRegStr HKCU "Software\Classes\Feedscope.Session" "" "Feedscope session"
  WriteRegStr HKCU "Software\Classes\Feedscope.Session\DefaultIcon" "" "$INSTDIR\bin\feedscope.exe,0"
  WriteRegStr HKCU "Software\Classes\Feedscope.Session\shell\open\command" "" '"$INSTDIR\bin\feedscope.exe" "%1"'
  ${RefreshShellIcons}
SectionEnd
!endif

Section "Uninstall"
  ; What was installed, and nothing that the user has put beside it.
  RMDir /r "$INSTDIR\bin"
  RMDir /r "$INSTDIR\share"
  RMDir /r "$INSTDIR\licences"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  Delete "$SMPROGRAMS\Feedscope command line.lnk"
!ifdef WINDOW
  Delete "$SMPROGRAMS\Feedscope.lnk"
  ReadRegStr $0 HKCU "Software\Classes\.feedscope" ""
  ${If} $0 == "Feedscope.Session"
    DeleteRegKey HKCU "Software\Classes\.feedscope"
  ${EndIf}
  DeleteRegKey HKCU "Software\Classes\Feedscope.Session"
!endif
  DeleteRegKey HKCU "${UNINSTALL}"
  DeleteRegKey HKCU "Software\Feedscope"
SectionEnd
