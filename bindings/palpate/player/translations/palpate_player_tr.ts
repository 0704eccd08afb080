<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>Player</name>
    <message>
        <source>Play</source>
        <translation>Oyna</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Düzey</translation>
    </message>
    <message>
        <source>To feel: nothing is judged.</source>
        <translation>Hissetmek için: hiçbir şey değerlendirilmez.</translation>
    </message>
    <message>
        <source>Reviewed by nobody yet</source>
        <translation>Henüz kimse incelemedi</translation>
    </message>
    <message>
        <source>Reviewed: %1</source>
        <translation>İnceleyen: %1</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Senaryolar</translation>
    </message>
    <message>
        <source>No published scenarios in %1</source>
        <translation>%1 içinde yayımlanmış senaryo yok</translation>
    </message>
    <message>
        <source>%1 s beyond</source>
        <translation>%1 s aşıldı</translation>
    </message>
    <message>
        <source>, goal: at least %1</source>
        <translation>, hedef: en az %1</translation>
    </message>
    <message>
        <source>, goal: at most %1</source>
        <translation>, hedef: en çok %1</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Yeniden</translation>
    </message>
    <message>
        <source>Another seed, or the next level.</source>
        <translation>Başka bir tohum ya da sonraki düzey.</translation>
    </message>
    <message>
        <source>As a guest: kept under no code</source>
        <translation>Konuk olarak: kodsuz saklanır</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Kalem</translation>
    </message>
    <message>
        <source>moves the tip</source>
        <translation>ucu hareket ettirir</translation>
    </message>
    <message>
        <source>Its button</source>
        <translation>Düğmesi</translation>
    </message>
    <message>
        <source>here and in the menu: as Enter</source>
        <translation>burada ve menüde: Enter gibi</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Fare</translation>
    </message>
    <message>
        <source>Attempts before</source>
        <translation>Önceki denemeler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Hatalar</translation>
    </message>
    <message>
        <source>Finish every step; there is no hurry.</source>
        <translation>Her adımı tamamlayın; acele etmeyin.</translation>
    </message>
    <message>
        <source>Go on with this code</source>
        <translation>Bu kodla devam et</translation>
    </message>
    <message>
        <source>I agree</source>
        <translation>Kabul ediyorum</translation>
    </message>
    <message>
        <source>I do not: practice, nothing is kept</source>
        <translation>Kabul etmiyorum: alıştırma, hiçbir şey saklanmaz</translation>
    </message>
    <message>
        <source>I have no code yet</source>
        <translation>Henüz kodum yok</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Saklandığı yer: %1</translation>
    </message>
    <message>
        <source>Nobody has the code %1 on this computer.</source>
        <translation>Bu bilgisayarda %1 kodu kimsenin değil.</translation>
    </message>
    <message>
        <source>Not allowed:</source>
        <translation>Yapılmaması gerekenler:</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>En yüksek kuvvet</translation>
    </message>
    <message>
        <source>Practice: nothing is kept</source>
        <translation>Alıştırma: hiçbir şey saklanmaz</translation>
    </message>
    <message>
        <source>Practice: nothing was kept.</source>
        <translation>Alıştırma: hiçbir şey saklanmadı.</translation>
    </message>
    <message>
        <source>The database cannot be used, so nothing can be kept: %1</source>
        <translation>Veritabanı kullanılamıyor, hiçbir şey saklanamaz: %1</translation>
    </message>
    <message>
        <source>The mouse gives no force: these numbers are not comparable.</source>
        <translation>Fare kuvvet vermez: bu sayılar karşılaştırılamaz.</translation>
    </message>
    <message>
        <source>The same again, to bring every goal within its bound.</source>
        <translation>Aynısını bir daha, her hedefi sınırına getirmek için.</translation>
    </message>
    <message>
        <source>The same, with fewer pauses between the steps.</source>
        <translation>Aynısı, adımlar arasında daha az duraksayarak.</translation>
    </message>
    <message>
        <source>To try next</source>
        <translation>Sonra denenecek</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Uyarılar</translation>
    </message>
    <message>
        <source>What is kept</source>
        <translation>Neler saklanır</translation>
    </message>
    <message>
        <source>Who plays?</source>
        <translation>Kim oynuyor?</translation>
    </message>
    <message>
        <source>Worst moments</source>
        <translation>En kötü anlar</translation>
    </message>
    <message>
        <source>Your attempts are kept under a code, without your name.</source>
        <translation>Denemeleriniz adınız olmadan bir kod altında saklanır.</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Kodunuz</translation>
    </message>
    <message>
        <source>Your code is %1. Write it down: nobody can find it for you.</source>
        <translation>Kodunuz %1. Bir yere yazın: sizin için kimse bulamaz.</translation>
    </message>
    <message>
        <source>done</source>
        <translation>tamam</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>başarısız</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>kesildi</translation>
    </message>
    <message>
        <source>left</source>
        <translation>bırakıldı</translation>
    </message>
    <message>
        <source>time over</source>
        <translation>süre doldu</translation>
    </message>
    <message>
        <source>Time %1. Peak force %2 N.</source>
        <translation>Süre %1. En yüksek kuvvet %2 N.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Başla</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Duraklatıldı</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Devam et</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Yeniden başlat</translation>
    </message>
    <message>
        <source>Full screen on or off</source>
        <translation>Tam ekranı aç ya da kapat</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Çık</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Koyu</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Açık</translation>
    </message>
    <message>
        <source>The run was ended</source>
        <translation>Deneme sonlandırıldı</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Tamamlandı</translation>
    </message>
    <message>
        <source>Record: %1</source>
        <translation>Kayıt: %1</translation>
    </message>
    <message>
        <source>Paused: no force from the device. %1. %2 C clears the fault.</source>
        <translation>Duraklatıldı: cihazdan kuvvet gelmiyor. %1. %2 C tuşu arızayı siler.</translation>
    </message>
    <message>
        <source>Paused: no force from the device. %1. %2</source>
        <translation>Duraklatıldı: cihazdan kuvvet gelmiyor. %1. %2</translation>
    </message>
    <message>
        <source>The device reported a position where no hand reaches, so its force was switched off. Check its calibration, then press R to start again.</source>
        <translation>Cihaz hiçbir elin ulaşamayacağı bir konum bildirdi, bu nedenle kuvveti kapatıldı. Kalibrasyonunu denetleyin, sonra yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>The device reported a speed that no hand has, so its force was switched off. Check its cable, then press R to start again.</source>
        <translation>Cihaz hiçbir elin ulaşamayacağı bir hız bildirdi, bu nedenle kuvveti kapatıldı. Kablosunu denetleyin, sonra yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>Paused: the motors of the device are off, so no force can be felt. Press R to start again.</source>
        <translation>Duraklatıldı: cihazın motorları kapalı, bu nedenle kuvvet hissedilmez. Yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Süre</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kuvvet</translation>
    </message>
    <message>
        <source>peak %1 N</source>
        <translation>en yüksek %1 N</translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation>sınır %1 N</translation>
    </message>
    <message>
        <source>Paused. Space goes on.</source>
        <translation>Duraklatıldı. Boşluk tuşu devam ettirir.</translation>
    </message>
    <message>
        <source>Something went wrong that should not: %1. Press R to restart.</source>
        <translation>Olmaması gereken bir hata oluştu: %1. Yeniden başlatmak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>The device cannot be used, so nothing was started: %1</source>
        <translation>Cihaz kullanılamıyor, bu nedenle hiçbir şey başlatılmadı: %1</translation>
    </message>
    <message>
        <source>No record can be written, so nothing was started: %1</source>
        <translation>Kayıt yazılamıyor, bu nedenle hiçbir şey başlatılmadı: %1</translation>
    </message>
    <message>
        <source>The record could not be completed: %1</source>
        <translation>Kayıt tamamlanamadı: %1</translation>
    </message>
    <message>
        <source>Not validated. Not a medical device.</source>
        <translation>Doğrulanmamıştır. Tıbbi cihaz değildir.</translation>
    </message>
    <message>
        <source>The computed force was not a number, so the force was switched off. Press R to start again.</source>
        <translation>Hesaplanan kuvvet bir sayı değildi, bu nedenle kuvvet kapatıldı. Yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>This computer is too slow just now: %1 of the last %2 force updates were missed.</source>
        <translation>Bu bilgisayar şu anda çok yavaş: son %2 kuvvet güncellemesinden %1 tanesi kaçırıldı.</translation>
    </message>
    <message>
        <source>The force was damped %1 times: it was about to push the hand along by itself.</source>
        <translation>Kuvvet %1 kez sönümlendi: eli kendiliğinden sürüklemek üzereydi.</translation>
    </message>
    <message>
        <source>The force was switched off after %1 s: %2. %3 Press R to start again.</source>
        <translation>%1 s sonra kuvvet kapatıldı: %2. %3 Yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>The device reported a position that is not a number, so its force was switched off. Check its cable, then press R to start again.</source>
        <translation>Cihaz sayı olmayan bir konum bildirdi, bu nedenle kuvveti kapatıldı. Kablosunu denetleyin, sonra yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>The device is gone: its cable is out, or it has fallen silent. Plug it in again, then press R to start again.</source>
        <translation>Cihaz kayboldu: kablosu çıkmış ya da sustu. Yeniden takın, sonra yeniden başlamak için R tuşuna basın.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Hareket</translation>
    </message>
    <message>
        <source>stroke along the surface</source>
        <translation>yüzeyi okşar</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>Sol düğme</translation>
    </message>
    <message>
        <source>press</source>
        <translation>bastırır</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Tekerlek</translation>
    </message>
    <message>
        <source>deeper or higher</source>
        <translation>daha derin ya da daha yüksek</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Sağ düğme</translation>
    </message>
    <message>
        <source>Beside the organ</source>
        <translation>Organın yanında</translation>
    </message>
    <message>
        <source>turn the view</source>
        <translation>görünümü döndürür</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Boşluk</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>duraklat</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>yeniden başlat</translation>
    </message>
    <message>
        <source>force arrow</source>
        <translation>kuvvet oku</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Dönüş</translation>
    </message>
    <message>
        <source>Turning %1</source>
        <translation>Dönüş %1</translation>
    </message>
    <message>
        <source>held by tissue</source>
        <translation>dokuca tutuluyor</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Gerilme</translation>
    </message>
    <message>
        <source>Stretch %1</source>
        <translation>Gerilme %1</translation>
    </message>
    <message>
        <source>Feels softer</source>
        <translation>Daha yumuşak hissedilir</translation>
    </message>
    <message>
        <source>Instrument %1</source>
        <translation>Alet %1</translation>
    </message>
    <message>
        <source>Jaws</source>
        <translation>Çeneler</translation>
    </message>
    <message>
        <source>Jaws %1</source>
        <translation>Çeneler %1</translation>
    </message>
    <message>
        <source>full screen</source>
        <translation>tam ekran</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>menü</translation>
    </message>
    <message>
        <source>T shows the task</source>
        <translation>T görevi gösterir</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Klasörü aç</translation>
    </message>
    <message>
        <source>This system does not open folders. It is %1</source>
        <translation>Bu sistem klasör açmıyor. Klasör: %1</translation>
    </message>
    <message>
        <source>Every run is recorded in %1</source>
        <translation>Her çalışma şurada kaydedilir: %1</translation>
    </message>
    <message>
        <source>task</source>
        <translation>görev</translation>
    </message>
    <message>
        <source>The task is done. Errors: %1.</source>
        <translation>Görev tamamlandı. Hata: %1.</translation>
    </message>
    <message>
        <source>The task has failed. Errors: %1.</source>
        <translation>Görev başarısız oldu. Hata: %1.</translation>
    </message>
    <message>
        <source>The time for the task is over. Errors: %1.</source>
        <translation>Görevin süresi doldu. Hata: %1.</translation>
    </message>
    <message>
        <source>The device failed before the task was done.</source>
        <translation>Görev tamamlanmadan cihaz arızalandı.</translation>
    </message>
    <message>
        <source>The task could not be judged to its end.</source>
        <translation>Görev sonuna kadar değerlendirilemedi.</translation>
    </message>
    <message>
        <source>The task was left before it was done. Errors: %1.</source>
        <translation>Görev tamamlanmadan bırakıldı. Hata: %1.</translation>
    </message>
    <message>
        <source>%1 attempts</source>
        <translation>%1 deneme</translation>
    </message>
    <message>
        <source>A simulated hand shows how it is done. Esc leaves it.</source>
        <translation>Simüle bir el nasıl yapıldığını gösteriyor. Esc çıkar.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Geri</translation>
    </message>
    <message>
        <source>Buzz at the wall: %1 mm, at most %2 mm</source>
        <translation>Duvarda titreşim: %1 mm, en çok %2 mm</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Yeniden denetle</translation>
    </message>
    <message>
        <source>Check the device</source>
        <translation>Cihazı denetle</translation>
    </message>
    <message>
        <source>Device check</source>
        <translation>Cihaz denetimi</translation>
    </message>
    <message>
        <source>Device check: hold the tool still.</source>
        <translation>Cihaz denetimi: aleti kıpırdatmadan tutun.</translation>
    </message>
    <message>
        <source>Device check: press the middle with %1 to %2 N for a second.</source>
        <translation>Cihaz denetimi: ortaya bir saniye %1 ile %2 N arası bastırın.</translation>
    </message>
    <message>
        <source>Device check: press the stop button of the device.</source>
        <translation>Cihaz denetimi: cihazın durdurma düğmesine basın.</translation>
    </message>
    <message>
        <source>Device check: release the stop button.</source>
        <translation>Cihaz denetimi: durdurma düğmesini bırakın.</translation>
    </message>
    <message>
        <source>Device check: touch the marked point, %1 of %2.</source>
        <translation>Cihaz denetimi: işaretli noktaya dokunun, %1 / %2.</translation>
    </message>
    <message>
        <source>Drift: %1 mm, at most %2 mm</source>
        <translation>Kayma: %1 mm, en çok %2 mm</translation>
    </message>
    <message>
        <source>Each device and level stands for itself: they cannot be compared.</source>
        <translation>Her cihaz ve düzey kendi başınadır: karşılaştırılamazlar.</translation>
    </message>
    <message>
        <source>Force of the motors: %1 % off, at most %2 %</source>
        <translation>Motorların kuvveti: %1 % sapma, en çok %2 %</translation>
    </message>
    <message>
        <source>Force updates: %1 ms late, at most %2 ms</source>
        <translation>Kuvvet güncellemesi: %1 ms geç, en çok %2 ms</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Devam</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geçmiş</translation>
    </message>
    <message>
        <source>Lost reports: %1 %, at most %2 %</source>
        <translation>Kayıp ileti: %1 %, en çok %2 %</translation>
    </message>
    <message>
        <source>No attempts are kept of you.</source>
        <translation>Saklanan denemeniz yok.</translation>
    </message>
    <message>
        <source>Noise: %1 mm, at most %2 mm</source>
        <translation>Gürültü: %1 mm, en çok %2 mm</translation>
    </message>
    <message>
        <source>Pictures: %1 a second, at least %2</source>
        <translation>Görüntü: saniyede %1, en az %2</translation>
    </message>
    <message>
        <source>Points touched: %1 of %2</source>
        <translation>Dokunulan nokta: %1 / %2</translation>
    </message>
    <message>
        <source>Round trip: %1 ms, at most %2 ms</source>
        <translation>Gidiş dönüş: %1 ms, en çok %2 ms</translation>
    </message>
    <message>
        <source>Show me how it is done</source>
        <translation>Nasıl yapıldığını göster</translation>
    </message>
    <message>
        <source>Sounds off</source>
        <translation>Sesler kapalı</translation>
    </message>
    <message>
        <source>Sounds on</source>
        <translation>Sesler açık</translation>
    </message>
    <message>
        <source>Step done</source>
        <translation>Adım tamam</translation>
    </message>
    <message>
        <source>Stop button</source>
        <translation>Durdurma düğmesi</translation>
    </message>
    <message>
        <source>The device cannot be checked: %1</source>
        <translation>Cihaz denetlenemiyor: %1</translation>
    </message>
    <message>
        <source>The device is as it should be.</source>
        <translation>Cihaz olması gerektiği gibi.</translation>
    </message>
    <message>
        <source>The device is not as it should be: attempts with it would not count, so there is practice alone.</source>
        <translation>Cihaz olması gerektiği gibi değil: onunla yapılan denemeler sayılmaz, bu yüzden yalnız alıştırma yapılabilir.</translation>
    </message>
    <message>
        <source>The device failed before its check was over: look at its cable, then check again. Until then there is practice alone.</source>
        <translation>Cihaz, denetimi bitmeden arızalandı: kablosuna bakın, sonra yeniden denetleyin. O zamana dek yalnız alıştırma yapılabilir.</translation>
    </message>
    <message>
        <source>The device was not checked, so there is practice alone.</source>
        <translation>Cihaz denetlenmedi, bu yüzden yalnız alıştırma yapılabilir.</translation>
    </message>
    <message>
        <source>The simulated hand cannot play: %1</source>
        <translation>Simüle el oynayamıyor: %1</translation>
    </message>
    <message>
        <source>The simulated hand gets ready. Esc leaves it.</source>
        <translation>Simüle el hazırlanıyor. Esc vazgeçer.</translation>
    </message>
    <message>
        <source>The task cannot be shown: %1</source>
        <translation>Görev gösterilemiyor: %1</translation>
    </message>
    <message>
        <source>Time of %1 attempts</source>
        <translation>%1 denemenin süresi</translation>
    </message>
    <message>
        <source>Wall pressed: %1 s of %2 s</source>
        <translation>Duvara basıldı: %1 s / %2 s</translation>
    </message>
    <message>
        <source>Your attempts so far</source>
        <translation>Şimdiye kadarki denemeleriniz</translation>
    </message>
    <message>
        <source>could not be judged</source>
        <translation>değerlendirilemedi</translation>
    </message>
    <message>
        <source>device failed</source>
        <translation>cihaz arızalandı</translation>
    </message>
    <message>
        <source>errors: %1</source>
        <translation>hata: %1</translation>
    </message>
    <message>
        <source>haptic arm</source>
        <translation>dokunsal kol</translation>
    </message>
    <message>
        <source>mouse, no force</source>
        <translation>fare, kuvvet yok</translation>
    </message>
    <message>
        <source>Another one of this kind</source>
        <translation>Bu türden bir başkası</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>The organ cannot be drawn on this machine: %1</source>
        <translation>Organ bu makinede çizilemiyor: %1</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>Sol düğme</translation>
    </message>
    <message>
        <source>press and stroke</source>
        <translation>bastır ve sıvazla</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Sağ düğme</translation>
    </message>
    <message>
        <source>click and hold to pull</source>
        <translation>tıkla, basılı tut ve çek</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Tekerlek</translation>
    </message>
    <message>
        <source>deeper or higher</source>
        <translation>daha derin ya da daha yüksek</translation>
    </message>
    <message>
        <source>Beside the organ</source>
        <translation>Organın yanında</translation>
    </message>
    <message>
        <source>turn the view</source>
        <translation>görünümü döndür</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Hareket</translation>
    </message>
    <message>
        <source>stroke at this depth</source>
        <translation>bu derinlikte sıvazla</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Bırak</translation>
    </message>
    <message>
        <source>lift off</source>
        <translation>geri çekil</translation>
    </message>
    <message>
        <source>close the jaws and pull</source>
        <translation>çeneleri kapat ve çek</translation>
    </message>
    <message>
        <source>close the jaws, or open them</source>
        <translation>çeneleri kapat ya da aç</translation>
    </message>
    <message>
        <source>open the jaws</source>
        <translation>çeneleri aç</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Shift + tekerlek</translation>
    </message>
    <message>
        <source>turn the instrument</source>
        <translation>aleti döndür</translation>
    </message>
    <message>
        <source>Alt + wheel</source>
        <translation>Alt + tekerlek</translation>
    </message>
    <message>
        <source>lean it</source>
        <translation>aleti eğ</translation>
    </message>
    <message>
        <source>Laparoscope</source>
        <translation>Laparoskop</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Oda</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Sekme</translation>
    </message>
    <message>
        <source>instrument %1</source>
        <translation>%1. alet</translation>
    </message>
    <message>
        <source>pull sideways</source>
        <translation>yana çek</translation>
    </message>
    <message>
        <source>pull nearer or push away</source>
        <translation>yaklaştır ya da uzaklaştır</translation>
    </message>
    <message>
        <source>release the tissue</source>
        <translation>dokuyu serbest bırak</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>A sensor reads the end of its scale: a wire is off or shorted. Repair it, then clear the fault.</source>
        <translation>Bir algılayıcı ölçeğinin ucunu okuyor: bir kablo kopuk ya da kısa devre. Onarın, sonra arızayı silin.</translation>
    </message>
    <message>
        <source>Bytes lost</source>
        <translation>Bayt kaybı</translation>
    </message>
    <message>
        <source>Blank board</source>
        <translation>Boş kart</translation>
    </message>
    <message>
        <source>Calibration damaged</source>
        <translation>Kalibrasyon bozuk</translation>
    </message>
    <message>
        <source>Check the motor drivers, their supply and its fuse, then clear the fault.</source>
        <translation>Motor sürücülerini, beslemelerini ve sigortayı denetleyin, sonra arızayı silin.</translation>
    </message>
    <message>
        <source>Clear the fault to go on.</source>
        <translation>Sürdürmek için arızayı silin.</translation>
    </message>
    <message>
        <source>Damaged frame</source>
        <translation>Bozuk çerçeve</translation>
    </message>
    <message>
        <source>Emergency stop pressed</source>
        <translation>Acil durdurma basılı</translation>
    </message>
    <message>
        <source>Firmware overrun</source>
        <translation>Aygıt yazılımı yetişemedi</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Gitti</translation>
    </message>
    <message>
        <source>Greeting</source>
        <translation>Tanışıyor</translation>
    </message>
    <message>
        <source>Host silent</source>
        <translation>Bilgisayar sustu</translation>
    </message>
    <message>
        <source>It carries its own arm. Hold the stylus.</source>
        <translation>Kendi kolunu taşıyor. Kalemi tutun.</translation>
    </message>
    <message>
        <source>The device is being identified.</source>
        <translation>Cihaz tanınıyor.</translation>
    </message>
    <message>
        <source>Its cable is out, or it has fallen silent. Plug it in and connect again.</source>
        <translation>Kablosu çıkmış ya da aygıt susmuş. Takıp yeniden bağlanın.</translation>
    </message>
    <message>
        <source>Its joints are read; nothing can push.</source>
        <translation>Eklemleri okunuyor; hiçbir şey itemez.</translation>
    </message>
    <message>
        <source>Its program hung and was restarted. Clear the fault; if it comes again, flash it again.</source>
        <translation>Yazılımı takıldı ve yeniden başlatıldı. Arızayı silin; yinelenirse yazılımı yeniden yükleyin.</translation>
    </message>
    <message>
        <source>Its sensors are read, but mean nothing without a calibration: calibrate it. Its motors stay off until then.</source>
        <translation>Algılayıcıları okunuyor ama kalibrasyon olmadan bir anlam taşımıyor: kalibre edin. O zamana dek motorları kapalı kalır.</translation>
    </message>
    <message>
        <source>Let the motors cool for a minute, then clear the fault.</source>
        <translation>Motorlar bir dakika soğusun, sonra arızayı silin.</translation>
    </message>
    <message>
        <source>Message refused</source>
        <translation>İleti geri çevrildi</translation>
    </message>
    <message>
        <source>Motor driver fault</source>
        <translation>Motor sürücüsü arızası</translation>
    </message>
    <message>
        <source>Motor too hot</source>
        <translation>Motor çok sıcak</translation>
    </message>
    <message>
        <source>Motors coming on</source>
        <translation>Motorlar açılıyor</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motorlar kapalı</translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation>Motorlar açık</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Çok hızlı hareket</translation>
    </message>
    <message>
        <source>No fault</source>
        <translation>Arıza yok</translation>
    </message>
    <message>
        <source>No calibration was ever stored in it: calibrate it. Its motors stay off until then.</source>
        <translation>İçine hiç kalibrasyon yazılmamış: kalibre edin. O zamana dek motorları kapalı kalır.</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Kalibre edilmemiş</translation>
    </message>
    <message>
        <source>Release the stop button, then clear the fault.</source>
        <translation>Durdurma düğmesini bırakın, sonra arızayı silin.</translation>
    </message>
    <message>
        <source>Reports are missing</source>
        <translation>Raporlar eksik</translation>
    </message>
    <message>
        <source>Reset by its watchdog</source>
        <translation>Bekçi sıfırladı</translation>
    </message>
    <message>
        <source>Sensor fault</source>
        <translation>Algılayıcı arızası</translation>
    </message>
    <message>
        <source>The arm moved too fast. Hold the stylus, then clear the fault.</source>
        <translation>Kol çok hızlı hareket etti. Kalemi tutun, sonra arızayı silin.</translation>
    </message>
    <message>
        <source>The force is taken back until reports come again.</source>
        <translation>Raporlar yeniden gelene dek kuvvet geri çekilir.</translation>
    </message>
    <message>
        <source>This computer did not speak to it for 20 ms, so it cut its motors. Clear the fault; if it comes again, close what keeps the computer busy.</source>
        <translation>Bu bilgisayar onunla 20 ms konuşmadı, o da motorlarını kesti. Arızayı silin; yinelenirse bilgisayarı meşgul eden programları kapatın.</translation>
    </message>
    <message>
        <source>Unknown fault</source>
        <translation>Bilinmeyen arıza</translation>
    </message>
    <message>
        <source>The newest copy of its calibration in its EEPROM is damaged, and an older one is not obeyed: calibrate it. Its motors stay off until then.</source>
        <translation>EEPROM’undaki kalibrasyonun en yeni kopyası bozuk, eskisine de uyulmuyor: kalibre edin. O zamana dek motorları kapalı kalır.</translation>
    </message>
    <message>
        <source>Its stored data cannot be read: calibrate it.</source>
        <translation>Sakladığı veriler okunamıyor: kalibre edin.</translation>
    </message>
</context>
</TS>
